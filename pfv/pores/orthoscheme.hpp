#pragma once

namespace pfv {

/// What a ball has of an orthoscheme, see ball_in_orthoscheme.
struct OrthoschemePart {
  double volume;  // m^3, of the ball
  double surface; // m^2, of the sphere
  double base;    // m^2, of the disc in which the sphere cuts the plane of the base E R P
};

/// The part of a ball about k in the tetrahedron k E R P whose edges k E, E R and R P (m) are at right angles to each
/// other, exactly. In the directions that leave it through the disc it is a cone on the disc, in the others a sector:
///
///   volume = r^3 / 3 (Omega - omega) + |k E| / 3 base,  surface = r^2 (Omega - omega),
///
/// Omega the solid angle of the tetrahedron at k, omega that of the disc in it. Edges may be negative: volume and
/// surface have the sign of the product of all three, the base that of E R and R P.
OrthoschemePart ball_in_orthoscheme(double radius, double to_base, double along_base, double height);

} // namespace pfv
