#include "console/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <simulate/run.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

using namespace ricochet;
using namespace ricochet::simulate;
namespace fs = std::filesystem;

namespace {

Scene bounce(const std::string& duration) {
  std::string text = read_file(RICOCHET_SOURCE_DIR "/data/scenes/bounce.json");
  const std::string was = "\"duration\": 0.5";
  return read_scene("bounce.json", text.replace(text.find(was), was.size(), "\"duration\": " + duration));
}

/// What a run says of an output that it cannot write in a process with this limit; "" where it can.
std::string refused_within(int resource, rlim_t most, const Scene& scene, const std::string& folder, Format format) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{most, most};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
    try {
      run(
          scene, folder, false, [] {}, format);
    } catch (const console::CannotWrite& error) {
      const std::string what = error.what();
      ::_exit(::write(ends[1], what.data(), what.size()) < 0);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string what(1000, '\0');
  what.resize(std::max<ssize_t>(0, ::read(ends[0], what.data(), what.size())));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  return what;
}

}  // namespace

TEST_CASE("an interrupted run, resumed, gives the bytes of one that was never stopped") {
  const TemporaryFolder folder;
  const Scene scene = bounce("2");
  const std::string whole = folder.path() / "whole", parts = folder.path() / "parts";
  REQUIRE(run(scene, whole, false) == 0);
  // Noted as the run begins; test_resume.cpp stops in the middle of contacts.
  REQUIRE(run(scene, parts, false, [] { std::raise(SIGINT); }) == SIGINT);
  CHECK(read_file(parts + "/trajectory.xyz").size() < read_file(whole + "/trajectory.xyz").size());
  // What was written after the state is cut away again.
  std::ofstream(parts + "/energy.csv", std::ios::app) << "half a li";
  CHECK(run(scene, parts, true) == 0);
  for (const char* file : {"/trajectory.xyz", "/contacts.csv", "/energy.csv", "/state.json"})
    CHECK(read_file(parts + file) == read_file(whole + file));
  CHECK(run(scene, parts, true) == 0);  // nothing left to do
  CHECK(read_file(whole + "/state.json").find("\"unconverged_steps\":0") != std::string::npos);
}

TEST_CASE("a run that breaks down leaves what can be resumed, or nothing") {
  const TemporaryFolder folder;
  Scene scene = bounce("0.01");
  // The check of a scene would refuse this step; the energy of a fall this fast overflows within the run, not at its
  // start.
  scene.setup.gravity = {0, 0, -1e160};
  CHECK_THROWS_AS(run(scene, folder.path() / "falls", false), console::Failed);
  for (const char* file : {"trajectory.xyz", "contacts.csv", "energy.csv", "state.json"}) {
    const std::string text = read_file(folder.path() / "falls" / file);
    CAPTURE(file);
    CHECK(!text.empty());
    CHECK(text.find("inf") == std::string::npos);
    CHECK(text.find("nan") == std::string::npos);
  }
  CHECK_THROWS_AS(run(scene, folder.path() / "falls", true), console::Failed);  // goes on, to the same end
  scene.setup.spheres[0].velocity = {0, 0, 1e200};
  CHECK_THROWS_WITH(run(scene, folder.path() / "flies", false), Catch::StartsWith("t = 0: "));
  CHECK_FALSE(fs::exists(folder.path() / "flies"));
}

TEST_CASE("contacts.csv names a permanent contact, and a breakage where the contact can take up no more") {
  // Two spheres of 8.38e-3 kg meet at 1 m/s: ½ m v² = 2.1e-3 J of their effective mass.
  const auto ended = [](const std::string& energy) {
    const TemporaryFolder folder;
    const std::string scene = R"({"duration": 1, "materials": {"clay": {"density": 2000}}, "interactions": [{"between":
      ["clay", "clay"], "law": {"name": "fractional", "k": 1000, "c": 1, "alpha": 1})" +
                              energy + R"(}], "spheres": [
      {"radius": 0.01, "material": "clay", "position": [0, 0, 0], "velocity": [0.5, 0, 0]},
      {"radius": 0.01, "material": "clay", "position": [0.0201, 0, 0], "velocity": [-0.5, 0, 0]}]})";
    REQUIRE(run(read_scene("clay.json", scene), folder.path(), false) == 0);
    return read_file(folder.path() / "contacts.csv");
  };
  CHECK(ended("").find(",,permanent contact,compression") != std::string::npos);
  CHECK(ended(R"(, "breakage_energy": 3e-3)").find(",,permanent contact,") != std::string::npos);
  CHECK(ended(R"(, "breakage_energy": 1e-3)").find(",,breakage,compression") != std::string::npos);
}

TEST_CASE("a run that cannot begin leaves nothing, so that another can") {
  const TemporaryFolder folder;
  const Scene scene = bounce("0.01");
  const int next = ::open("/dev/null", O_RDONLY);
  ::close(next);
  for (const Format format : {Format::xyz, Format::vtk})
    for (const int files : {0, 1, 2, 3}) {  // that can be opened at once; a fourth one is needed, the state's
      CAPTURE(files);
      CHECK_THAT(refused_within(RLIMIT_NOFILE, rlim_t(next + files), scene, folder.path() / "a/b", format),
                 Catch::Contains(": cannot write: Too many open files"));
      CHECK(fs::is_empty(folder.path()));
    }
  fs::create_directory(folder.path() / "c");
  fs::create_symlink("nowhere", folder.path() / "c/energy.csv");
  CHECK_THROWS_WITH(run(scene, folder.path() / "c", false), Catch::Contains("holds energy.csv without the state.json"));
}

TEST_CASE("frames whose first state cannot be written are taken back") {
  const TemporaryFolder folder;
  const Scene scene = bounce("0.01");
  REQUIRE(run(
              scene, folder.path() / "whole", false, [] {}, Format::vtk) == 0);
  const auto frame = fs::file_size(folder.path() / "whole/vtk/spheres.000000.vtk");
  REQUIRE(frame < fs::file_size(folder.path() / "whole/state.json"));
  CHECK_THAT(refused_within(RLIMIT_FSIZE, frame, scene, folder.path() / "none", Format::vtk),
             Catch::Contains("state.json: cannot write: File too large"));
  CHECK_FALSE(fs::exists(folder.path() / "none"));
}

TEST_CASE("a run does not overwrite another, nor continue one of another scene") {
  const TemporaryFolder folder;
  const Scene scene = bounce("0.01");
  REQUIRE(run(scene, folder.path(), false) == 0);
  CHECK_THROWS_WITH(run(scene, folder.path(), false), Catch::Contains("holds a run already; --resume"));
  CHECK_THROWS_WITH(run(bounce("0.02"), folder.path(), true), Catch::Contains("of another scene"));
  CHECK_THROWS_WITH(run(scene, folder.path() / "none", true),
                    (folder.path() / "none/state.json").string() + ": cannot be read: No such file or directory");
  fs::create_directory(folder.path() / "somebodys");
  std::ofstream(folder.path() / "somebodys/energy.csv") << "mine";
  CHECK_THROWS_WITH(run(scene, folder.path() / "somebodys", false),
                    Catch::Contains("holds energy.csv without the state.json of a run"));
  CHECK(read_file(folder.path() / "somebodys/energy.csv") == "mine");
  const auto cut = [&](const char* file, auto&& damage) {
    const fs::path path = folder.path() / file;
    const std::string whole = read_file(path);
    damage(path);
    try {
      run(scene, folder.path(), true);
    } catch (const console::BadInput& error) {
      std::ofstream(path) << whole;
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  for (const char* file : {"trajectory.xyz", "contacts.csv", "energy.csv"}) {
    const std::string path = (folder.path() / file).string();
    CHECK(cut(file, [](const fs::path& p) { fs::remove(p); }) ==
          path + ": missing: No such file or directory; start again without --resume");
    CHECK(cut(file, [](const fs::path& p) { fs::resize_file(p, fs::file_size(p) - 1); }) ==
          path + ": shorter than when the state was saved; start again without --resume");
  }
  CHECK(run(scene, folder.path(), true) == 0);
  std::ofstream(folder.path() / "state.json") << "{}";
  CHECK_THROWS_WITH(run(scene, folder.path(), true), Catch::Contains("must be a state that simulate saved"));
}

TEST_CASE("a run ends where bodies go through each other, and says which, when and how fast") {
  const TemporaryFolder folder;
  // From rest under a gravity that makes it 45 m/s at the wall: nobody can know at the start.
  const auto scene = [](const std::string& k, const std::string& gravity) {
    return read_scene("s.json", R"({"duration": 0.2, "gravity": [0, 0, -)" + gravity + R"(],
  "materials": {"g": {"density": 2000}, "w": {}},
  "interactions": [{"between": ["g", "w"], "law": {"name": "linear", "k": )" +
                                    k + R"(, "c": 0}}],
  "spheres": [{"radius": 0.01, "material": "g", "position": [0, 0, 1.01]}],
  "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "w"}]})");
  };
  // It falls 1 m in sqrt(2/1000) s = 0.0447 s; 0.015 m deep at 44.9 m/s less what the spring takes.
  CHECK_THROWS_WITH(run(scene("1e4", "1000"), folder.path() / "wall", false),
                    Catch::Matchers::Matches("t = 0\\.045[0-9]* s: bodies 1 and wall1 have gone into each other by "
                                             "more than 1\\.5 radii, at 4[0-4]\\.?[0-9]* m/s: a stiffer law, or slower "
                                             "bodies, are needed\\. All before is written"));
  CHECK(read_file(folder.path() / "wall/trajectory.xyz").find("Time=0.044") != std::string::npos);
  CHECK(run(scene("1e6", "1000"), folder.path() / "stiff", false) == 0);
  // Who insists is told, and stopped where it comes about: at 100 m/s, and at 1e4 m/s, which a step cannot resolve.
  const auto insisting = [](const std::string& speed) {
    return read_scene("s.json", R"({"insist": true, "duration": 0.01, "materials": {"g": {"density": 2000}},
  "interactions": [{"between": ["g", "g"], "law": {"name": "linear", "k": 1e4, "c": 0}}],
  "spheres": [{"radius": 0.01, "material": "g", "position": [0, 0, 0], "velocity": [)" +
                                    speed +
                                    R"(, 0, 0]}, {"radius": 0.01, "material": "g", "position": [0.03, 0, 0]}]})");
  };
  // The gap of 0.01 m, then 0.015 m of the 0.0647 m that the spring would take: 0.251 ms; a step has 0.01 ms.
  CHECK_THROWS_WITH(
      run(insisting("100"), folder.path() / "fast", false),
      Catch::Matchers::Matches("t = 0\\.0002[56][0-9]* s: bodies 1 and 2 have gone into each other by more "
                               "than 1\\.5 radii, at 9[0-9]\\.?[0-9]* m/s: .*"));
  CHECK_THROWS_WITH(run(insisting("1e4"), folder.path() / "faster", false),
                    Catch::Contains(" body 1 moves by more than its radius in a step, at 1e+04 m/s"));
  Scene coarse = scene("1e6", "1000");
  coarse.options.step = 1e-3;
  CHECK_THROWS_WITH(run(coarse, folder.path() / "coarse", false),
                    Catch::Matchers::Matches("t = 0\\.011 s: body 1 moves by more than its radius in a step, at "
                                             "11 m/s: a smaller \"step\" is needed.*"));
}
