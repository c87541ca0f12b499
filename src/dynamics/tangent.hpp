// Charts of the attitude, and how neighbouring motions separate in them.
//
// A neighbour of an attitude Q is exp(e) Q with a small rotation vector e. In a chart x(Q) it is at
// x + J e: J is also what makes x' = J omega of the angular velocity in the space frame. Of
// "rotation" x is e itself, and J = 1. E is singular where theta = 2 pi k, k != 0 [P7], M where
// theta = pi (M0 = 0) [P8], G is infinite there [P10], the MRP where theta = 2 pi.
#pragma once

#include "dynamics/chart.hpp"
#include "motion/run.hpp"
#include "rotation/frame.hpp"

namespace rotor {

/// J at a state, whose axis and angle only the chart of E needs.
Matrix chart_jacobian(Chart chart, const State& state);

/// A, the Jacobian of the chart's equation of motion x' = f(omega, x) by x, where omega is given in
/// `frame`: the linearised motion in the chart is d' = A d, of e it is e' = omega x e in the space
/// frame, 0 in the body frame. omega in rad per unit of t, in that frame.
Matrix rate_jacobian(Chart chart, const State& state, const Vector& omega, Frame frame);

/// |M0| or |M|, whichever is zero where the chart is singular, if the state is near enough to its
/// singularity for that to matter; 1 elsewhere.
double distance_from_singularity(Chart chart, const State& state);

/// Which of the parts it is in, into which the chart's singularity divides the attitudes: 0, 1 by
/// the sign of M0 for M and G, the number of turns for E; 0 for the others.
double part_of_chart(Chart chart, const State& state);

}  // namespace rotor
