// Order gates for code that nobody here wrote: a stepper of Boost.Odeint and the numerical derivatives of Eigen.

#include <ricochet/verify/order.hpp>

#include <catch2/catch.hpp>

#include <Eigen/Core>
#include <boost/numeric/odeint.hpp>
#include <unsupported/Eigen/NumericalDiff>

#include <cmath>

namespace odeint = boost::numeric::odeint;
using ricochet::verify::observe_order;
using ricochet::verify::refined;

namespace {

/// Error at t = 1 of x' = x, x(0) = 1.
template <class Stepper>
double error_of_stepper(double h) {
  double x = 1;
  const auto rate = [](const double& state, double& out, double) { out = state; };
  odeint::integrate_n_steps(Stepper(), rate, x, 0.0, h, static_cast<std::size_t>(std::lround(1 / h)));
  return x - std::exp(1.0);
}

/// sin, in the form that Eigen's NumericalDiff takes.
struct Sine {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  int inputs() const { return 1; }
  int values() const { return 1; }
  int operator()(const InputType& x, ValueType& value) const {
    value[0] = std::sin(x[0]);
    return 0;
  }
};

/// Error of the derivative of sin at 1; Eigen steps by √epsfcn |x|.
template <Eigen::NumericalDiffMode mode>
double error_of_derivative(double h) {
  const Eigen::NumericalDiff<Sine, mode> derivative(Sine(), h * h);
  Eigen::MatrixXd slope(1, 1);
  derivative.df(Eigen::VectorXd::Ones(1), slope);
  return slope(0, 0) - std::cos(1.0);
}

}  // namespace

TEST_CASE("Odeint's steppers have the orders that they state") {
  const auto h = refined(0.125, 7);
  CHECK(observe_order(error_of_stepper<odeint::euler<double>>, h, {.stated = 1}));
  CHECK(observe_order(error_of_stepper<odeint::modified_midpoint<double>>, h, {.stated = 2}));
  CHECK(observe_order(error_of_stepper<odeint::runge_kutta4<double>>, h, {.stated = 4}));
  CHECK_FALSE(observe_order(error_of_stepper<odeint::runge_kutta4<double>>, h, {.stated = 3}));
}

TEST_CASE("Eigen's numerical derivatives are of first and of second order") {
  const auto h = refined(0.1, 8);
  CHECK(observe_order(error_of_derivative<Eigen::Forward>, h, {.stated = 1}));
  CHECK(observe_order(error_of_derivative<Eigen::Central>, h, {.stated = 2}));
  CHECK_FALSE(observe_order(error_of_derivative<Eigen::Forward>, h, {.stated = 2}));
}
