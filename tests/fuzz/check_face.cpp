#include "fuzz/check_face.hpp"

#include "fuzz/check_neighbors.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace abut::fuzz {
namespace {

std::string written(const ImagePair& image) {
  const auto [pair, n] = image;
  return "(" + std::to_string(pair.first) + ", " + std::to_string(pair.second) + "; " +
         std::to_string(n.x) + " " + std::to_string(n.y) + " " + std::to_string(n.z) + ")";
}

/// Both ascend.
void require_same(const std::vector<ImagePair>& expected, const std::vector<ImagePair>& found) {
  if (expected == found) return;
  std::string text = std::to_string(expected.size()) + " pairs expected, " +
                     std::to_string(found.size()) + " found";
  const auto differing = std::ranges::mismatch(expected, found);
  if (differing.in1 != expected.end()) text += "; expected " + written(*differing.in1);
  if (differing.in2 != found.end()) text += "; found " + written(*differing.in2);
  throw Failure(text);
}

std::vector<ImagePair> without_shifts(std::vector<ImagePair> images) {
  for (ImagePair& image : images) image.shift = {};
  std::ranges::sort(images);
  return images;
}

/// The pairs and their shifts; zeros where there are none.
std::vector<ImagePair> images_of(std::span<const ContactPair> pairs,
                                 std::span<const ImageShift> shifts) {
  std::vector<ImagePair> result;
  result.reserve(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    result.push_back({pairs[k], shifts.empty() ? ImageShift{} : shifts[k]});
  }
  return result;
}

template <class Source>
constexpr bool is_detector = std::same_as<Source, AskedDetector>;

template <class Source>
void require_sound(const Source& source, const Statistics& statistics) {
  const Question& question = source.question;
  const auto require = [&](bool holds, const char* what) {
    if (!holds) throw Failure(std::string("statistics: ") + what);
  };
  require(statistics.contact_pairs == question.expected().pairs.size(), "contact_pairs");
  require(statistics.elements == question.element_count(), "elements");
  require(statistics.dimensions == question.system().first.dimensions, "dimensions");
  require(statistics.exact_decisions <= statistics.candidate_tests, "exact_decisions");
  require(statistics.threads >= 1 && statistics.threads <= std::max(1, source.options.threads),
          "threads");
  if (is_detector<Source>) return;
  require(statistics.candidate_tests >= statistics.contact_pairs, "candidate_tests");
  const Algorithm asked = source.options.algorithm;
  require(asked == Algorithm::automatic || asked == statistics.algorithm, "algorithm");
}

template <class Source>
void check_list(Source source, Order order, Shifts shifts) {
  source.options.order = order;
  source.options.shifts = shifts;
  const PairList& list = source.list();
  if ((shifts == Shifts::none) != list.shifts().empty() && !list.empty()) {
    throw Failure("shifts are stored only if asked for");
  }
  std::vector<ImagePair> found = images_of(list.pairs(), list.shifts());
  if (order == Order::as_found) std::ranges::sort(found);
  const std::vector<ImagePair>& pairs = source.question.expected().pairs;
  require_same(shifts == Shifts::none ? without_shifts(pairs) : pairs, found);
  require_sound(source, list.statistics());
}

template <class Source>
void check_limits(Source source) {
  const std::uint64_t count = source.question.expected().pairs.size();
  source.options.max_pairs = count;
  check_list(source, Order::canonical, Shifts::stored);
  if (count == 0) return;
  source.options.max_pairs = count - 1;
  try {
    static_cast<void>(source.list());
  } catch (const Error& error) {
    if (error.code() == ErrorCode::limit_exceeded) return;
    throw;
  }
  throw Failure("max_pairs = " + std::to_string(count - 1) + " is not kept");
}

/// Batches come from several workers at once; from one they come in the order of the list as found.
template <class Source>
void check_batches(Source source) {
  std::mutex mutex;
  std::vector<ImagePair> found;
  const Statistics statistics =
      source.visit(PairBatchVisitor([&](std::span<const ContactPair> pairs, WorkerNumber) {
        const std::lock_guard lock(mutex);
        for (const ContactPair pair : pairs) found.push_back({pair, {}});
      }));
  require_sound(source, statistics);
  if (source.options.threads == 1) {
    source.options.order = Order::as_found;
    const PairList& list = source.list();
    if (images_of(list.pairs(), {}) != found) throw Failure("batches differ from what is found");
  }
  std::ranges::sort(found);
  require_same(without_shifts(source.question.expected().pairs), found);
}

template <class Source>
void check_shifted_batches(const Source& source) {
  std::mutex mutex;
  std::vector<ImagePair> found;
  const Statistics statistics = source.visit(ShiftedBatchVisitor(
      [&](std::span<const ContactPair> pairs, std::span<const ImageShift> shifts, WorkerNumber) {
        const std::lock_guard lock(mutex);
        for (std::size_t k = 0; k < pairs.size(); ++k) found.push_back({pairs[k], shifts[k]});
      }));
  require_sound(source, statistics);
  std::ranges::sort(found);
  require_same(source.question.expected().pairs, found);
}

/// The order as found is the same for any number of threads.
void check_order_of_threads(FreeFunctions source) {
  source.options.order = Order::as_found;
  source.options.shifts = Shifts::stored;
  const PairList list = source.list();
  source.options.threads = source.options.threads % 3 + 1;
  const PairList other = source.list();
  if (!std::ranges::equal(list.pairs(), other.pairs()) ||
      !std::ranges::equal(list.shifts(), other.shifts())) {
    throw Failure("another order as found with another number of threads");
  }
}

template <class Source>
void check(Face face, const Source& source) {
  switch (face) {
    case Face::canonical_list:
      return check_list(source, Order::canonical, Shifts::stored);
    case Face::as_found_list:
      check_list(source, Order::as_found, Shifts::stored);
      if constexpr (!is_detector<Source>) check_order_of_threads(source);
      return;
    case Face::list_without_shifts:
      return check_list(source, Order::canonical, Shifts::none);
    case Face::limited_list:
      return check_limits(source);
    case Face::count:
      return require_sound(source, source.count());
    case Face::batches:
      return check_batches(source);
    case Face::shifted_batches:
      return check_shifted_batches(source);
    case Face::half_neighbors:
    case Face::full_neighbors: {
      const auto kind =
          face == Face::half_neighbors ? NeighborListKind::half : NeighborListKind::full;
      const NeighborList& list = source.neighbors(kind);
      require_sound(source, list.statistics());
      return check_neighbors(source.question, source.options, kind, list);
    }
  }
}

}  // namespace

const char* name_of(Face face) {
  constexpr std::array<const char*, all_faces.size()> names{
      "canonical_list", "as_found_list",   "list_without_shifts", "limited_list",  "count",
      "batches",        "shifted_batches", "half_neighbors",      "full_neighbors"};
  return names[static_cast<std::size_t>(face)];
}

void check_face(Face face, const FreeFunctions& source) {
  check(face, source);
}

void check_face(Face face, const AskedDetector& source) {
  check(face, source);
}

}  // namespace abut::fuzz
