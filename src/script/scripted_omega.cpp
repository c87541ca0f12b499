#include "script/scripted_omega.hpp"

#include <array>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrate/loop.hpp"
#include "rotation/text.hpp"
#include "script/convert.hpp"
#include "script/interpreter.hpp"
#include "script/interrupt.hpp"
#include "script/lua_value.hpp"
#include "spin/attitude_spin.hpp"
#include "spin/jet_check.hpp"

namespace rotor::script {
namespace {

std::string describe_results(lua_State* L, int first, int count) {
  std::string list = count == 0 ? "nothing" : "";
  for (int i = 0; i < count && i < 8; ++i) list += (i == 0 ? "" : ", ") + describe(L, first + i);
  return list + (count > 8 ? ", ... (" + std::to_string(count) + " values)" : "");
}

// What a call with a jet raised, with what helps where something did not take it.
std::string with_hint(const std::string& raised) {
  const bool refused =
      raised.find("got jet") != raised.npos || raised.find("a jet value") != raised.npos;
  return raised + (refused ? "; jets go through + - * / ^ and sin, cos, ..., and three of them or "
                             "{x, y, z} are what to return (help \"jet\")"
                           : "");
}

/// A function of one number, as a script gave it.
class Callee {
 public:
  /// `role` is what messages call it, `variable` its argument.
  Callee(lua_State* L, int index, const char* role, const char* variable)
      : function_(L, index), variable_(variable) {
    lua_Debug info;
    lua_pushvalue(L, index);
    lua_getinfo(L, ">S", &info);
    name_ = role + (" (function at " + std::string(info.short_src)) +
            (info.linedefined > 0 ? ":" + std::to_string(info.linedefined) : "") + ")";
  }

  /// "omega (function at script.lua:3)"
  const std::string& name() const { return name_; }
  std::string at(double t) const { return std::string(" at ") + variable_ + " = " + text(t); }

  /// What `read(L, first, count)` makes of the results of a call with t.
  template <class Read>
  auto operator()(double t, const Read& read) const {
    lua_State* const L = current_state();
    luaL_checkstack(L, 8, "omega");
    lua_pushcfunction(L, add_traceback);
    const int handler = lua_gettop(L);
    function_.push(L);
    lua_pushnumber(L, t);
    if (lua_pcall(L, 1, LUA_MULTRET, handler) != LUA_OK) raise(L, t);
    const auto result = read(L, handler + 1, lua_gettop(L) - handler);
    lua_settop(L, handler - 1);  // not a StackGuard: this is called millions of times
    return result;
  }

  /// The N jets or numbers that a call with a jet gives, or a table of them; NotDifferentiable
  /// where it fails.
  template <std::size_t N>
  std::array<Jet, N> with_jet(const Jet& t) const {
    lua_State* const L = current_state();
    const StackGuard guard(L);
    luaL_checkstack(L, 8, "omega");
    const int first = lua_gettop(L) + 1;
    function_.push(L);
    Convert<Jet>::push(L, t);
    if (lua_pcall(L, 1, LUA_MULTRET, 0) != LUA_OK) {
      if (interrupt_pending()) throw Interrupted();
      throw NotDifferentiable(with_hint(luaL_tolstring(L, -1, nullptr)));
    }
    const int count = lua_gettop(L) - first + 1;
    if (count == 1 && N > 1) spread<N>(L, first);
    std::array<Jet, N> jets;
    if (lua_gettop(L) - first + 1 != static_cast<int>(N)) refuse(L, first, count);
    for (std::size_t i = 0; i < N; ++i) {
      const int place = first + static_cast<int>(i);
      if (lua_type(L, place) != LUA_TNUMBER && test_user_value<Jet>(L, place) == nullptr) {
        refuse(L, first, count);
      }
      jets[i] = Convert<Jet>::get(L, place);
    }
    return jets;
  }

  [[noreturn]] void not_differentiable(double t, const NotDifferentiable& why) const {
    throw NotDifferentiable(name_ + " cannot be differentiated" + at(t) + ": " + why.what());
  }

 private:
  // Of the error value on top of the stack.
  [[noreturn]] void raise(lua_State* L, double t) const {
    if (interrupt_pending()) throw Interrupted();
    auto value = std::make_shared<const Reference>(L, -1);
    std::string raised = describe(L, -1);
    if (lua_isstring(L, -1) || luaL_getmetafield(L, -1, "__tostring") != LUA_TNIL) {
      value->push(L);
      raised = luaL_tolstring(L, -1, nullptr);
    }
    throw ScriptError(std::move(value), name_ + " failed" + at(t) + ": " + raised);
  }

  // Puts the items of the table or vec at `first` in its place.
  template <std::size_t N>
  static void spread(lua_State* L, int first) {
    if (const Vector* v = test_user_value<Vector>(L, first)) {
      for (const double x : *v) lua_pushnumber(L, x);
    } else if (lua_istable(L, first)) {
      for (std::size_t i = 1; i <= N; ++i) lua_rawgeti(L, first, static_cast<lua_Integer>(i));
    } else {
      return;
    }
    lua_remove(L, first);
  }

  [[noreturn]] static void refuse(lua_State* L, int first, int count) {
    throw NotDifferentiable("called with a jet it gives " + describe_results(L, first, count));
  }

  Reference function_;
  std::string name_;
  const char* variable_;
};

// The jets about t of a function whose plain call at s is value(s). Beyond the end of where it is
// defined it may fail.
template <std::size_t N, class Value>
std::array<Jet, N> checked_jet(const Callee& function, double t, const Value& value) {
  try {
    const auto jets = function.with_jet<N>(Jet::variable(t));
    check_jet(jets, t, [&](double s) -> Vector {
      try {
        return value(s);
      } catch (const ScriptError&) {
        if (s == t) throw;
        return Vector::Constant(std::numeric_limits<double>::quiet_NaN());
      }
    });
    return jets;
  } catch (const NotDifferentiable& why) {
    function.not_differentiable(t, why);
  }
}

class ScriptedSpin final : public SpinModel {
 public:
  ScriptedSpin(lua_State* L, int index) : function_(L, index, "omega", "t") {}

  Vector value(double t) const override {
    return function_(t, [this, t](lua_State* L, int first, int count) {
      if (count == 3 && lua_type(L, first) == LUA_TNUMBER &&
          lua_type(L, first + 1) == LUA_TNUMBER && lua_type(L, first + 2) == LUA_TNUMBER) {
        return Vector(lua_tonumber(L, first), lua_tonumber(L, first + 1),
                      lua_tonumber(L, first + 2));
      }
      return vector_of(L, first, count, t);
    });
  }
  std::string description() const override { return function_.name(); }
  bool dear() const override { return true; }

  VectorJet jet(double t) const override {
    return checked_jet<3>(function_, t, [this](double s) { return value(s); });
  }

 private:
  Vector vector_of(lua_State* L, int first, int count, double t) const {
    if (count == 1 && (lua_istable(L, first) || test_user_value<Vector>(L, first) != nullptr)) {
      try {
        return Convert<Vector>::get(L, first);
      } catch (const Mismatch& mismatch) {
        throw std::runtime_error(function_.name() + function_.at(t) + ": " + mismatch.what());
      }
    }
    throw std::runtime_error(function_.name() + function_.at(t) +
                             ": expected three numbers, a table {x, y, z} or a vec, got " +
                             describe_results(L, first, count));
  }

  Callee function_;
};

double number_of(const Callee& function, double t) {
  return function(t, [&](lua_State* L, int first, int count) {
    if (count == 1 && lua_type(L, first) == LUA_TNUMBER) return lua_tonumber(L, first);
    throw std::runtime_error(function.name() + function.at(t) + ": expected a number, got " +
                             describe_results(L, first, count));
  });
}

std::shared_ptr<const Callee> callee(lua_State* L, int index, const char* role,
                                     const char* variable) {
  if (!lua_isfunction(L, index)) throw Mismatch(L, index, "a function of " + std::string(variable));
  return std::make_shared<const Callee>(L, index, role, variable);
}

}  // namespace

AngularVelocity scripted_omega(lua_State* L, int index) {
  if (const AngularVelocity* w = test_user_value<AngularVelocity>(L, index)) return *w;
  if (const Spline* spline = test_user_value<Spline>(L, index)) {
    return {std::make_shared<const AttitudeSpin>(*spline)};
  }
  if (!lua_isfunction(L, index)) return Convert<Vector>::get(L, index);
  return {std::make_shared<const ScriptedSpin>(L, index)};
}

ScalarFunction scripted_scalar(lua_State* L, int index) {
  const auto function = callee(L, index, "rate", "t");
  return {.value = [function](double t) { return number_of(*function, t); },
          .jet =
              [function](double t) {
                return checked_jet<1>(*function, t, [&](double s) {
                  return Vector(number_of(*function, s), 0, 0);
                })[0];
              },
          .name = function->name(),
          .dear = true};
}

std::function<Jet(const Jet&)> scripted_jet_function(lua_State* L, int index) {
  const auto function = callee(L, index, "f", "theta");
  return [function](const Jet& theta) {
    const double x = theta.c[0];
    try {
      const Jet jet = function->with_jet<1>(theta)[0];
      const double value = number_of(*function, x);
      if (jet.c[0] != value) {
        throw NotDifferentiable("called with a number it gives " + text(value) + ", with a jet " +
                                text(jet.c[0]));
      }
      return jet;
    } catch (const NotDifferentiable& why) {
      function->not_differentiable(x, why);
    }
  };
}

}  // namespace rotor::script
