#pragma once

namespace abut::fuzz {

/// Whole numbers of any length keep the memory that they give back, by sizes, for the next ones:
/// they come and go by the thousands in a case, and a general allocator, above all one that looks
/// for errors, would take most of the time. For one thread.
void keep_memory_of_numbers();

}  // namespace abut::fuzz
