// The two frames.
#pragma once

namespace rotor {

/// Where something is given: in the body (the axes of a sequence: intrinsic, Q = Q1 Q2 ... Qn), or
/// in space (extrinsic: Q = Qn ... Q2 Q1).
enum class Frame { kBody, kSpace };

}  // namespace rotor
