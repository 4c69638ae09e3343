#include <ricochet/verify/order.hpp>

#include <cmath>
#include <iostream>

// The trapezoid rule of e^x on [0, 1] is of second order, and of no other.
int main() {
  using namespace ricochet::verify;
  const auto error = [](double h) {
    const long n = std::lround(1 / h);
    double sum = 0.5 * (1 + std::exp(1.0));
    for (long i = 1; i < n; ++i) sum += std::exp(static_cast<double>(i) * h);
    return sum * h - (std::exp(1.0) - 1);
  };
  const auto h = refined(0.25, 6);
  const ObservedOrder observed = observe_order(error, h, {.stated = 2});
  std::cout << observed << "\n";
  return observed && !observe_order(error, h, {.stated = 1}) && !observe_order(error, h, {.stated = 3}) ? 0 : 1;
}
