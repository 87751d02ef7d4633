<?xml version='1.0' encoding='UTF-8' standalone='yes'?>
<!-- Where the pages of CGAL's manual are that ours refers to. -->
<tagfile>
  <compound kind="page">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="page">
    <name>IOStreamMedit</name>
    <title>MEDIT (.mesh) file format</title>
    <filename>Stream_support/IOStreamSupportedFileFormats.html</filename>
  </compound>
  <compound kind="page">
    <name>PkgMesh3</name>
    <title>3D Mesh Generation</title>
    <filename>Mesh_3/index.html</filename>
  </compound>
  <compound kind="page">
    <name>PkgSMDS3</name>
    <title>3D Simplicial Mesh Data Structures</title>
    <filename>SMDS_3/index.html</filename>
  </compound>
  <compound kind="page">
    <name>PkgSurfaceMeshParameterization</name>
    <title>Triangulated Surface Mesh Parameterization</title>
    <filename>Surface_mesh_parameterization/index.html</filename>
  </compound>
  <compound kind="page">
    <name>PkgTetrahedralRemeshing</name>
    <title>Tetrahedral Remeshing</title>
    <filename>Tetrahedral_remeshing/index.html</filename>
  </compound>
  <compound kind="page">
    <name>licensesGPL</name>
    <title>GPL</title>
    <filename>Manual/license.html</filename>
  </compound>
  <compound kind="class">
    <name>MeshComplex_3InTriangulation_3</name>
    <filename>SMDS_3/classMeshComplex__3InTriangulation__3.html</filename>
  </compound>
  <compound kind="class">
    <name>MeshComplexWithFeatures_3InTriangulation_3</name>
    <filename>SMDS_3/classMeshComplexWithFeatures__3InTriangulation__3.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
</tagfile>
