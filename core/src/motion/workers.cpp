#include <ricochet/motion/engine/workers.hpp>

namespace ricochet::motion {

Workers::Workers(std::size_t threads) {
  others_.reserve(threads - 1);
  for (std::size_t worker = 1; worker < threads; ++worker) others_.emplace_back([this, worker] { work(worker); });
}

Workers::~Workers() {
  over_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& other : others_) other.join();
}

namespace {

// Parts of one step follow each other within microseconds, and a thread that sleeps takes tens to wake: until the
// value is another than `seen`, looks for a while before it sleeps.
void await_other(const std::atomic<unsigned>& value, unsigned seen) {
  constexpr int looks = 200;
  for (int n = 0; n < looks; ++n) {
    if (value.load(std::memory_order_acquire) != seen) return;
    std::this_thread::yield();
  }
  value.wait(seen, std::memory_order_acquire);
}

}  // namespace

void Workers::run(const Part& part) {
  part_ = &part;
  busy_.store(static_cast<unsigned>(others_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  part(0);
  for (unsigned left = busy_.load(std::memory_order_acquire); left > 0; left = busy_.load(std::memory_order_acquire))
    await_other(busy_, left);
}

void Workers::work(std::size_t worker) {
  for (unsigned seen = 0;;) {
    await_other(round_, seen);
    seen = round_.load(std::memory_order_acquire);
    if (over_) return;
    (*part_)(worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

}  // namespace ricochet::motion
