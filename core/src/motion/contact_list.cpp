#include <ricochet/motion/contact_list.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace ricochet {

ContactList::ContactList(std::vector<ContactState> contacts) : records_(std::move(contacts)), order_(records_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
}

std::uint32_t ContactList::place_of(NearPair pair) const noexcept {
  const auto before = [this](std::uint32_t record, NearPair other) { return pair_of(records_[record]) < other; };
  return static_cast<std::uint32_t>(std::lower_bound(order_.begin(), order_.end(), pair, before) - order_.begin());
}

std::vector<ContactList::Stay> ContactList::exchange(std::span<const std::uint32_t> gone,
                                                     std::span<const ContactState> born,
                                                     std::span<std::uint32_t> places) {
  std::vector<Stay> stays = stays_between(gone, places);
  next_order_.resize(order_.size() + born.size() - gone.size());
  for (const Stay& s : stays)
    std::copy(order_.begin() + s.first, order_.begin() + s.last, next_order_.begin() + s.first + s.shift);
  for (const std::uint32_t place : gone) vacant_.push_back(order_[place]);
  for (std::size_t k = 0; k < born.size(); ++k) next_order_[places[k]] = keep(born[k]);
  std::swap(order_, next_order_);
  born_ += born.size();
  if (born_ > order_.size()) *this = ContactList(in_order());
  return stays;
}

std::vector<ContactList::Stay> ContactList::stays_between(std::span<const std::uint32_t> gone,
                                                          std::span<std::uint32_t> places) const {
  std::vector<Stay> stays;
  std::uint32_t from = 0;
  std::int32_t shift = 0;
  const auto stay_until = [&](std::uint32_t at) {
    if (at > from) stays.push_back({from, at, shift});
    from = at;
  };
  auto leaving = gone.begin();
  for (std::uint32_t& place : places) {
    for (; leaving != gone.end() && *leaving < place; ++leaving, ++from, --shift) stay_until(*leaving);
    stay_until(place);
    place += static_cast<std::uint32_t>(shift++);
  }
  for (; leaving != gone.end(); ++leaving, ++from, --shift) stay_until(*leaving);
  stay_until(static_cast<std::uint32_t>(order_.size()));
  return stays;
}

std::uint32_t ContactList::keep(const ContactState& contact) {
  if (vacant_.empty()) {
    records_.push_back(contact);
    return static_cast<std::uint32_t>(records_.size() - 1);
  }
  const std::uint32_t record = vacant_.back();
  vacant_.pop_back();
  records_[record] = contact;
  return record;
}

}  // namespace ricochet
