// Any text as a file of measurements: a fit whose every number is finite, or one line that says why there is none. The
// length of the input chooses law and end.

#include "measurements.hpp"
#include "memory_file.hpp"

#include <console/exit.hpp>

#include <algorithm>
#include <cmath>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

void expect(bool ok, const char* what) {
  if (!ok) throw std::logic_error(what);
}

FitRequest request_of(std::size_t choice) {
  // Without fractional-hertz, of which a fit takes seconds, and a minute with sanitizers.
  constexpr std::array laws{kind_of<Linear>,
                            kind_of<KuwabaraKono>,
                            kind_of<Tsuji>,
                            kind_of<Hysteretic>,
                            kind_of<Fractional>,
                            kind_of<Fractional>,
                            kind_of<FractionalKelvinVoigt>,
                            kind_of<FractionalZener>};
  const std::size_t place = choice % laws.size();
  FitRequest request{laws[place], ContactEnd::force, 7e-6, place == 5};
  if (choice % 4 == 3 && request.law.ends().offer(ContactEnd::overlap)) request.end = ContactEnd::overlap;
  return request;
}

void check(const Fit& fit, std::size_t measurements) {
  expect(std::isfinite(fit.chi2) && fit.chi2 >= 0 && std::isfinite(fit.aic), "a goodness that is not finite");
  expect(fit.probability >= 0 && fit.probability <= 1, "a probability that is none");
  for (const Estimate& p : fit.parameters)
    expect(std::isfinite(p.value) && std::isfinite(p.error) && p.error >= 0, "a parameter that is not finite");
  for (const auto& row : fit.correlations)
    for (const double c : row) expect(std::abs(c) <= 1 + 1e-6, "a correlation that is none");
  expect(fit.predictions.size() == measurements, "a prediction that was lost");
  for (const Prediction& p : fit.predictions)
    expect(p.en >= 0 && p.en <= 1 + 1e-9 && std::isfinite(p.tcol), "an impossible collision");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (std::count(data, data + size, '\n') > 10) return -1;
  const MemoryFile file(data, size);
  try {
    const auto measured = read_measurements(file.path()).data;
    check(fit_law(request_of(size), measured), measured.size());
  } catch (const console::BadInput& error) {
    expect(std::string(error.what()).find('\n') == std::string::npos, "more than one line");
  } catch (const NotConverged&) {
  } catch (const std::invalid_argument&) {  // too few of them
  }
  return 0;
}
