#include <verify/conformance.hpp>
#include <verify/order_check.hpp>
#include <verify/program.hpp>
#include <verify/registry.hpp>

int main(int argc, char** argv) {
  const auto studies = ricochet::verify::all_studies();
  ricochet::verify::Studies checks;
  checks.push_back(ricochet::verify::order_check());
  checks.push_back(ricochet::verify::conformance_check());
  return ricochet::verify::run_verify(studies, checks, argc, argv);
}
