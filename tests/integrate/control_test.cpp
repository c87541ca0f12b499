#include "integrate/control.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"

using rotor::ErrorBudget, rotor::step_factor;

TEST_CASE("steps that spend all they may never spend more than the accuracy") {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    const double accuracy = std::pow(10.0, -12 * uniform(generator));
    const double length = std::pow(10.0, 12 * uniform(generator) - 6);
    const double largest = std::pow(10.0, -4 * uniform(generator));  // step, as part of the way
    const double greed = trial % 2 == 0 ? 1 : uniform(generator);
    ErrorBudget budget(accuracy, length);
    double spent = 0;
    double done = 0;
    while (done < length) {
      const double h = std::min(length * largest * uniform(generator), length - done);
      done = length - done - h < 1e-12 * length ? length : done + h;
      const double error = greed * budget.allowed(h, done);
      budget.spend(error);
      spent += error;
    }
    CHECK(spent <= accuracy * (1 + 1e-12));  // 1e4 additions or so of half an ulp
    CHECK(budget.left() == Approx(accuracy - spent).epsilon(0).margin(1e-12 * accuracy));
  }
}

TEST_CASE("a step may always take what its length grants, at most the accuracy") {
  ErrorBudget budget(1e-6, 10);
  budget.spend(1e-6);  // nothing is left over
  CHECK(budget.allowed(1, 5) == Approx(0.5e-7));
  CHECK(ErrorBudget(1e-6, 10).allowed(10, 10) <= 1e-6);
  CHECK(ErrorBudget(1e-6, 10).allowed(1e-9, 1e-9) > 1e-8);  // a jump at the start is carried
}

TEST_CASE("the next step aims at nine tenths of what would just be allowed, within 1/5 and 5") {
  CHECK(step_factor(1e-9, 1e-9, 8) == Approx(0.9));
  CHECK(step_factor(1e-9, 256e-9, 8) == Approx(1.8));
  CHECK(step_factor(16e-9, 1e-9, 4) == Approx(0.45));
  CHECK(step_factor(0, 1e-9, 8) == 5);
  CHECK(step_factor(1e-300, 1e-9, 8) == 5);
  CHECK(step_factor(1, 1e-9, 8) == 0.2);
  CHECK(step_factor(std::numeric_limits<double>::infinity(), 1e-9, 8) == 0.2);
  CHECK(step_factor(1, 0, 8) == 0.2);
}

TEST_CASE("an error that is not a number makes the step shorter, and so does a spent budget") {
  CHECK(step_factor(1e-9, -1e-12, 8) == 0.2);
  CHECK(step_factor(std::numeric_limits<double>::quiet_NaN(), 1e-9, 8) == 0.2);
}
