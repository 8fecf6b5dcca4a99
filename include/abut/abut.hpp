#pragma once

#include <abut/algorithm.hpp>
#include <abut/column.hpp>
#include <abut/detect.hpp>
#include <abut/detector.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/error.hpp>
#include <abut/export.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>
#include <abut/progress.hpp>
#include <abut/simd.hpp>
#include <abut/statistics.hpp>
#include <abut/version.hpp>
