#include <ricochet/motion/engine/workers.hpp>

#include <algorithm>

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

void Workers::share(std::size_t count, std::size_t grain, const Part& part) {
  count_ = count, grain_ = grain, part_ = &part;
  busy_.store(static_cast<unsigned>(others_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  do_part(0);
  for (unsigned left = busy_.load(std::memory_order_acquire); left > 0; left = busy_.load(std::memory_order_acquire))
    busy_.wait(left, std::memory_order_acquire);
}

void Workers::do_part(std::size_t worker) const {
  const std::size_t grains = (count_ + grain_ - 1) / grain_, all = threads();
  const std::size_t first = grains * worker / all * grain_,
                    last = std::min(count_, grains * (worker + 1) / all * grain_);
  if (first < last) (*part_)(first, last, worker);
}

void Workers::work(std::size_t worker) {
  for (unsigned seen = 0;;) {
    round_.wait(seen, std::memory_order_acquire);
    seen = round_.load(std::memory_order_acquire);
    if (over_) return;
    do_part(worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

}  // namespace ricochet::motion
