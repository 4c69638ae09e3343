#include <verify/program.hpp>
#include <verify/registry.hpp>

int main(int argc, char** argv) {
  const auto studies = ricochet::verify::all_studies();
  return ricochet::verify::run_verify(studies, argc, argv);
}
