#include "io/write/contact_writer.hpp"

#include <abut/error.hpp>
#include <abut/measure.hpp>

#include <fmt/format.h>

namespace abut::io {
namespace {

constexpr std::string_view gap_names[] = {"gap"};
constexpr std::string_view normal_names[] = {"normal_x", "normal_y", "normal_z"};
constexpr std::string_view point_names[] = {"point_x", "point_y", "point_z"};
constexpr std::string_view distance_names[] = {"distance"};
constexpr std::string_view vector_names[] = {"vector_x", "vector_y", "vector_z"};

const double* first_number(std::span<const double> numbers) {
  return numbers.data();
}

const double* first_number(std::span<const Vector> vectors) {
  static_assert(sizeof(Vector) == 3 * sizeof(double));
  return vectors.data()->data();
}

}  // namespace

ContactWriter::ContactWriter(const ContactOutput& output, const ContactElements& elements,
                             std::span<const ContactPair> pairs, const ContactImages& images,
                             const ContactQuantities& quantities)
    : progress_(output.progress),
      now_{"write", 0, pairs.size()},
      file_(output.path, [this] { return is_cancelled(); }),
      elements_(elements),
      pairs_(pairs),
      images_(images),
      with_ids_(output.ids == IdColumns::with) {
  std::span<const double> gaps = quantities.gaps;
  if (gaps.size() != pairs.size()) {
    own_gaps_ = measure(elements.first.elements(), elements.partners().elements(),
                        {pairs, images.shifts}, Quantity::gap, images.domain)
                    .gaps;
    gaps = own_gaps_;
  }
  quantities_.push_back({"gap", gap_names, gaps.data()});
  const auto add = [this](std::string_view name, std::span<const std::string_view> names,
                          auto all) {
    if (!all.empty()) quantities_.push_back({name, names, first_number(all)});
  };
  add("normal", normal_names, quantities.normals);
  add("point", point_names, quantities.points);
  add("distance", distance_names, quantities.distances);
  add("vector", vector_names, quantities.vectors);
}

std::vector<std::string_view> ContactWriter::column_names() const {
  std::vector<std::string_view> names{"i", "j"};
  if (with_ids_) names.insert(names.end(), {"id_i", "id_j"});
  if (is_periodic()) names.insert(names.end(), {"nx", "ny", "nz"});
  for (const QuantityColumns& quantity : quantities_) {
    names.insert(names.end(), quantity.names.begin(), quantity.names.end());
  }
  return names;
}

void ContactWriter::write_bytes(std::span<const std::byte> bytes) {
  finish();
  file_.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void ContactWriter::finish() {
  file_.write(text_);
  text_.clear();
}

void ContactWriter::wrote(std::uint64_t steps) {
  constexpr std::size_t much = std::size_t{64} << 10;
  constexpr std::uint64_t steps_between_calls = 65536;
  if (text_.size() >= much) finish();
  now_.done += steps;
  if (now_.done - told_ < steps_between_calls) return;
  told_ = now_.done;
  if (!is_cancelled()) return;
  throw Error(ErrorCode::cancelled,
              fmt::format("cancelled after writing {:.0f} % of {} contact pairs",
                          100.0 * static_cast<double>(now_.done) / static_cast<double>(now_.total),
                          pairs_.size()));
}

bool ContactWriter::is_cancelled() const {
  return progress_ && progress_(now_) == ProgressAction::cancel;
}

}  // namespace abut::io
