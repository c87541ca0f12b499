#include "spin/model.hpp"

namespace rotor {

VectorJet SpinModel::jet(double) const {
  throw NotDifferentiable(description() + " does not tell its derivatives");
}

std::vector<double> SpinModel::breaks(double, double) const { return {}; }

}  // namespace rotor
