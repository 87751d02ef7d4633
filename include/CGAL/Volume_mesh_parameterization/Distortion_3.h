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

#include <limits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

The distortions \f$D = (D_{aa}, D_{ma}, D_{av}, D_{mv})\f$ of a map as in Jin et al.
\cgalCite{cgal:jqzctz-smvp-15}, section 5: mean and maximum, over the cells, of the distortion of angles
\f$\sigma_1/\sigma_3 + \sigma_3/\sigma_1\f$ and of the distortion of volumes \f$\det J + 1/\det J\f$, where
\f$\sigma_1 \ge \sigma_2 \ge \sigma_3\f$ are the singular values of the differential \f$J\f$ of the map in a cell. In
the means, a cell counts by its volume in the source. The values have no unit; 2 is without distortion, and none is smaller.
A value is infinite where a cell of the image is so flat that rounding leaves nothing of it. Without a valid map,
none is a number.
*/
struct Distortion_3
{
  double angle_mean = std::numeric_limits<double>::quiet_NaN();  ///< the mean distortion of angles, \f$D_{aa}\f$
  double angle_max = std::numeric_limits<double>::quiet_NaN();   ///< the largest distortion of angles, \f$D_{ma}\f$
  double volume_mean = std::numeric_limits<double>::quiet_NaN(); ///< the mean distortion of volumes, \f$D_{av}\f$
  double volume_max = std::numeric_limits<double>::quiet_NaN();  ///< the largest distortion of volumes, \f$D_{mv}\f$
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DISTORTION_3_H
