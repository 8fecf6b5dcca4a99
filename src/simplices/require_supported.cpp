#include "base/shortest_text.hpp"
#include "simplices/simplex_search.hpp"

#include <abut/error.hpp>

#include <cstddef>
#include <string>

namespace abut::simplices {
namespace {

/// Equal numbers are the same vertices if they are looked up in the same array.
bool are_same_vertices(const ElementView& a, const ElementView& b) {
  bool same = a.size() == b.size() && a.precision() == b.precision();
  for (int axis = 0; axis < a.dimensions(); ++axis) {
    same = same && a.center(axis).first == b.center(axis).first &&
           a.center(axis).stride_bytes == b.center(axis).stride_bytes;
  }
  return same;
}

}  // namespace

void require_same_dimensions(const SimplexView& first, const SimplexView& second) {
  if (first.dimensions() == second.dimensions()) return;
  throw Error(ErrorCode::wrong_usage,
              "the first simplices have " + std::to_string(first.dimensions()) +
                  " dimensions and the second " + std::to_string(second.dimensions()) +
                  "; give both the same number of dimensions");
}

void require_supported(const SimplexRequest& request) {
  if (request.options.margin != 0.0) {
    throw Error(ErrorCode::wrong_usage, "margin = " + base::shortest_text(request.options.margin) +
                                            "; simplices touch or do not, leave it 0");
  }
  if (!request.options.quantities.empty()) {
    throw Error(ErrorCode::wrong_usage,
                "nothing is measured of contacts of simplices; ask for no quantities");
  }
  if (request.others == nullptr) return;
  require_same_dimensions(request.first, *request.others);
  if (request.shared == SharedVertices::touching ||
      are_same_vertices(request.first.vertices(), request.others->vertices())) {
    return;
  }
  throw Error(ErrorCode::wrong_usage,
              "simplices of two sets share vertices only if both name those of one array; give "
              "both sets the same vertices, or SharedVertices::touching");
}

}  // namespace abut::simplices
