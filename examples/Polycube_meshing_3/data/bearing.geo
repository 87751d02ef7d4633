// A bronze bushing in a steel housing, in millimeters.
SetFactory("OpenCASCADE");
Box(1) = {-20, -20, 0, 40, 40, 16};
Cylinder(2) = {0, 0, 0, 0, 0, 16, 13};
Cylinder(3) = {0, 0, 0, 0, 0, 16, 8};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{3}; };
BooleanDifference(5) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
BooleanFragments{ Volume{4}; Delete; }{ Volume{5}; Delete; }
bushing() = Volume In BoundingBox {-14, -14, -1, 14, 14, 17};
housing() = Volume{:};
housing() -= {bushing()};
Physical Volume("bronze") = {bushing()};
Physical Volume("steel") = {housing()};
Mesh.MeshSizeMax = 2.5;
