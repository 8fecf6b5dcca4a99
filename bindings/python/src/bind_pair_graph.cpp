#include "bind.hpp"

#include "array_out.hpp"
#include "pair_arrays.hpp"

#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

/// Partners of each element, in compressed rows.
class Partners {
 public:
  Partners(std::span<const ContactPair> pairs, std::size_t elements)
      : begins_(elements + 1), partners_(2 * pairs.size()) {
    for (const ContactPair& pair : pairs) {
      ++begins_[pair.first];
      ++begins_[pair.second];
    }
    std::exclusive_scan(begins_.begin(), begins_.end(), begins_.begin(), std::uint64_t{0});
    std::vector<std::uint64_t> ends(begins_.begin(), begins_.end() - 1);
    for (const ContactPair& pair : pairs) {
      partners_[ends[pair.first]++] = pair.second;
      partners_[ends[pair.second]++] = pair.first;
    }
  }

  [[nodiscard]] std::span<const ElementIndex> of(std::size_t element) const {
    return std::span(partners_).subspan(begins_[element], begins_[element + 1] - begins_[element]);
  }

 private:
  std::vector<std::uint64_t> begins_;
  std::vector<ElementIndex> partners_;
};

/// Marks the elements that have fewer than `needed` contacts with elements that are not marked.
std::vector<std::uint8_t> marked_rattlers(const Partners& partners, std::size_t elements,
                                          std::size_t needed) {
  std::vector<std::size_t> contacts(elements);
  std::vector<std::uint8_t> is_rattler(elements);
  std::vector<std::size_t> to_remove;
  const auto mark_if_loose = [&](std::size_t element) {
    if (is_rattler[element] != 0 || contacts[element] >= needed) return;
    is_rattler[element] = 1;
    to_remove.push_back(element);
  };
  for (std::size_t k = 0; k < elements; ++k) contacts[k] = partners.of(k).size();
  for (std::size_t k = 0; k < elements; ++k) mark_if_loose(k);
  while (!to_remove.empty()) {
    const std::size_t removed = to_remove.back();
    to_remove.pop_back();
    for (const ElementIndex partner : partners.of(removed)) {
      --contacts[partner];
      mark_if_loose(partner);
    }
  }
  return is_rattler;
}

/// Numbers the connected parts by their smallest elements, ascending.
std::vector<std::int64_t> numbered_clusters(const Partners& partners, std::size_t elements) {
  std::vector<std::int64_t> cluster(elements, -1);
  std::vector<std::size_t> to_visit;
  std::int64_t count = 0;
  for (std::size_t start = 0; start < elements; ++start) {
    if (cluster[start] >= 0) continue;
    cluster[start] = count;
    to_visit.push_back(start);
    while (!to_visit.empty()) {
      const std::size_t element = to_visit.back();
      to_visit.pop_back();
      for (const ElementIndex partner : partners.of(element)) {
        if (cluster[partner] >= 0) continue;
        cluster[partner] = count;
        to_visit.push_back(partner);
      }
    }
    ++count;
  }
  return cluster;
}

template <class Function>
auto of_pairs(nb::handle pairs, std::size_t elements, Function&& function) {
  const PairArrays arrays(pairs, nb::none());
  arrays.require_indices_below(elements, elements);
  auto result = [&] {
    const nb::gil_scoped_release unlocked;
    return function(Partners(arrays.pairs(), elements));
  }();
  return given_away(std::move(result));
}

}  // namespace

void bind_pair_graph(nb::module_& module) {
  module.def(
      "rattlers",
      [](nb::handle pairs, std::size_t elements, std::size_t needed) {
        return of_pairs(pairs, elements, [&](const Partners& partners) {
          return marked_rattlers(partners, elements, needed);
        });
      },
      nb::arg("pairs"), nb::arg("elements"), nb::arg("needed"));
  module.def(
      "clusters",
      [](nb::handle pairs, std::size_t elements) {
        return of_pairs(pairs, elements, [&](const Partners& partners) {
          return numbered_clusters(partners, elements);
        });
      },
      nb::arg("pairs"), nb::arg("elements"));
}

}  // namespace abut::python
