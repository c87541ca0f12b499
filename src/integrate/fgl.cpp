#include "integrate/fgl.hpp"

#include <memory>

#include "integrate/fgl_flow.hpp"
#include "integrate/fgl_panels.hpp"
#include "integrate/fgl_steps.hpp"
#include "integrate/loop.hpp"
#include "integrate/sampler.hpp"

namespace rotor {
namespace {

template <class Method>
void follow(Method method, const Scene& scene, const Observer& observer, FglFlow& flow,
            Propagator& result) {
  result.stop = integrate(method, scene.t0, scene.t1, scene.max_steps, observer, result.cost);
  result.t1 = result.stop ? result.stop->t : scene.t1;
  result.error_estimate = method.error_estimate();
  flow.resolve_to(result.error_estimate / 32);
}

}  // namespace

void follow_by_fgl(const Scene& scene, const std::vector<double>& breaks, const Observer& observer,
                   Propagator& result) {
  result.accuracy = scene.accuracy;
  const auto flow = std::make_shared<FglFlow>(scene.omega, scene.t0);
  result.flow = flow;
  Sampler omega(scene.omega, result.cost, breaks);
  if (omega.dear()) {
    follow(FglPanels(scene, omega, flow), scene, observer, *flow, result);
  } else {
    follow(FglSteps(scene, omega, flow), scene, observer, *flow, result);
  }
}

}  // namespace rotor
