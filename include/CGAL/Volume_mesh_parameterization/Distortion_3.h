// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

The distortions \f$D = (D_{aa}, D_{ma}, D_{av}, D_{mv})\f$ of a map as in Jin et al.
\cgalCite{cgal:jqzctz-smvp-15}, section 5: the mean over the source's volume and the maximum of
\f$\sigma_1/\sigma_3 + \sigma_3/\sigma_1\f$ (angles) and of \f$D + 1/D\f$ with
\f$D = \sigma_1\sigma_2\sigma_3\f$ (volumes). All are at least 2.
*/
struct Distortion_3
{
  double angle_mean = 0;
  double angle_max = 0;
  double volume_mean = 0;
  double volume_max = 0;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DISTORTION_3_H
