#!/usr/bin/env python3
"""Checks that each C++ file includes the header of the standard library for the names of std:: that
it uses, itself or by its own header. Prints what is missing; exit code 1 if anything is.
  scripts/check_includes.py [--mend] [FILE]...      all files of the project where none is named
--mend inserts the missing lines into the block of standard headers, or behind the includes."""

import re
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("include", "src", "scenes", "cli", "benchmarks", "examples", "tests")

# Header: the names that it alone gives. Where several headers give a name, NAMES_OF_SEVERAL tells.
NAMES = {
    "algorithm": """adjacent_find all_of any_of binary_search clamp copy copy_backward copy_if copy_n
        count count_if equal equal_range fill fill_n find find_if find_if_not for_each for_each_n
        generate generate_n includes inplace_merge is_permutation is_sorted lexicographical_compare
        lower_bound max max_element merge min min_element minmax minmax_element mismatch
        next_permutation none_of nth_element partial_sort partition partition_point prev_permutation
        remove remove_if replace reverse rotate sample search set_difference set_intersection
        set_symmetric_difference set_union shuffle sort stable_partition stable_sort swap_ranges
        transform unique upper_bound ranges::sort ranges::find ranges::all_of ranges::any_of
        ranges::none_of ranges::copy ranges::equal ranges::fill ranges::max ranges::min
        ranges::stable_sort ranges::unique ranges::lower_bound ranges::upper_bound
        ranges::is_sorted ranges::reverse ranges::transform ranges::count ranges::count_if
        ranges::find_if ranges::for_each ranges::max_element ranges::min_element""",
    "array": "array to_array",
    "atomic": """atomic atomic_bool atomic_int atomic_flag atomic_ref atomic_thread_fence memory_order
        memory_order_relaxed memory_order_acquire memory_order_release memory_order_seq_cst""",
    "bit": """bit_cast bit_ceil bit_floor bit_width countl_one countl_zero countr_one countr_zero
        endian has_single_bit popcount rotl rotr""",
    "bitset": "bitset",
    "cerrno": "",
    "cfenv": """fegetround fesetround fegetenv fesetenv feholdexcept feclearexcept feraiseexcept
        fetestexcept fenv_t""",
    "charconv": "from_chars from_chars_result to_chars to_chars_result chars_format",
    "chrono": "chrono::steady_clock chrono::system_clock chrono::duration chrono::milliseconds",
    "cmath": """acos asin atan atan2 cbrt ceil copysign cos exp exp2 expm1 fabs fdim floor fma fmax
        fmin fmod frexp fpclassify hypot ilogb isfinite isinf isnan isnormal ldexp lerp llround log
        log10 log1p log2 logb lrint lround modf nan nearbyint nextafter pow remainder rint round
        scalbn signbit sin sqrt tan tanh trunc""",
    "compare": "strong_ordering weak_ordering partial_ordering",
    "complex": "complex",
    "concepts": """same_as convertible_to derived_from floating_point integral invocable predicate
        signed_integral unsigned_integral regular""",
    "condition_variable": "condition_variable",
    "csignal": "signal raise sig_atomic_t",
    "cstdarg": "va_list",
    "cstddef": "byte max_align_t nullptr_t ptrdiff_t",
    "cstdint": """int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t intptr_t uintptr_t
        uintmax_t intmax_t""",
    "cstdio": """FILE fclose fflush fopen fprintf fputs fread fwrite perror printf puts snprintf sscanf
        remove_file""",
    "cstdlib": """abort aligned_alloc atoi calloc exit _Exit free getenv malloc quick_exit realloc
        strtod strtof strtol strtoll strtoul strtoull system""",
    "cstring": """memchr memcmp memcpy memmove memset strchr strcmp strerror strlen strncmp strrchr
        strstr""",
    "deque": "deque",
    "exception": """exception current_exception exception_ptr make_exception_ptr rethrow_exception
        set_terminate terminate uncaught_exceptions""",
    "execution": "execution::par",
    "filesystem": "filesystem::path filesystem::exists filesystem::remove",
    "fstream": "fstream ifstream ofstream",
    "functional": """bind equal_to function greater invoke less minus multiplies not_fn plus ref cref
        reference_wrapper""",
    "future": "async future promise",
    "initializer_list": "initializer_list",
    "iomanip": "setfill setprecision setw",
    "ios": "ios_base",
    "iostream": "cerr cin clog cout",
    "iterator": """back_inserter back_insert_iterator distance forward_iterator_tag inserter
        istreambuf_iterator istream_iterator iterator_traits make_move_iterator next
        ostream_iterator prev random_access_iterator_tag reverse_iterator""",
    "limits": "numeric_limits",
    "list": "list",
    "map": "map multimap",
    "memory": """addressof allocate_shared allocator allocator_traits construct_at destroy_at
        destroy_n enable_shared_from_this make_shared make_unique shared_ptr to_address
        uninitialized_copy uninitialized_fill unique_ptr weak_ptr""",
    "mutex": "lock_guard mutex once_flag call_once scoped_lock unique_lock",
    "new": "align_val_t bad_alloc bad_array_new_length nothrow nothrow_t get_new_handler set_new_handler",
    "numbers": "numbers::pi numbers::sqrt2 numbers::sqrt3",
    "numeric": """accumulate adjacent_difference exclusive_scan gcd inclusive_scan inner_product iota
        lcm midpoint partial_sum reduce transform_reduce""",
    "optional": "make_optional nullopt optional",
    "queue": "priority_queue queue",
    "random": """mt19937 mt19937_64 normal_distribution poisson_distribution random_device
        uniform_int_distribution uniform_real_distribution""",
    "regex": "regex regex_match regex_search smatch",
    "set": "multiset set",
    "span": "as_bytes dynamic_extent span",
    "sstream": "istringstream ostringstream stringstream",
    "stack": "stack",
    "stdexcept": """domain_error invalid_argument length_error logic_error out_of_range overflow_error
        range_error runtime_error underflow_error""",
    "stop_token": "stop_token stop_source",
    "streambuf": "streambuf",
    "string": "basic_string getline stod stoi stol stoll stoul stoull string to_string",
    "string_view": "basic_string_view string_view",
    "thread": "jthread this_thread::sleep_for this_thread::yield thread",
    "tuple": "apply forward_as_tuple ignore make_tuple tie tuple tuple_cat",
    "type_traits": """add_const_t add_pointer_t bool_constant common_type_t conditional_t decay_t
        enable_if_t false_type integral_constant invoke_result_t is_arithmetic_v is_base_of_v
        is_const_v is_constant_evaluated is_convertible_v is_enum_v is_floating_point_v
        is_integral_v is_invocable_v is_invocable_r_v is_nothrow_move_assignable_v
        is_nothrow_move_constructible_v is_pointer_v is_reference_v is_same_v is_signed_v
        is_copy_constructible_v is_copy_assignable_v is_default_constructible_v
        is_trivial_v is_trivially_copyable_v is_trivially_destructible_v is_unsigned_v is_void_v
        make_signed_t make_unsigned_t remove_const_t remove_cv_t remove_cvref_t remove_pointer_t
        remove_reference_t true_type type_identity_t underlying_type_t void_t""",
    "typeinfo": "type_info",
    "unordered_map": "unordered_map unordered_multimap",
    "unordered_set": "unordered_multiset unordered_set",
    "utility": """as_const cmp_less declval exchange forward in_place in_place_t index_sequence
        integer_sequence make_index_sequence make_pair pair""",
    "variant": "get_if holds_alternative monostate variant visit",
    "vector": "vector",
    "version": "",
}
NAMES_OF_SEVERAL = {
    # Containers are spoken of in sizes: who includes one has the type.
    "size_t": {"cstddef", "cstdlib", "cstring", "cstdio", "array", "span", "string", "string_view",
               "vector"},
    "abs": {"cmath", "cstdlib"},
    "move": {"utility", "algorithm"},
    "swap": {"utility"},
    "swap_ranges": {"algorithm"},
    "errc": {"system_error", "charconv"},
    "error_code": {"system_error", "filesystem"},
    "remove": {"algorithm", "cstdio"},
    "hash": {"functional", "string", "string_view", "optional", "memory"},
    "ostream": {"ostream", "iostream", "sstream", "fstream"},
    "istream": {"istream", "iostream", "sstream", "fstream"},
    "ios": {"ios", "iostream", "sstream", "fstream"},
    "endl": {"ostream", "iostream"},
    "plus": {"functional"},
}
# A header that by its own definition brings another.
BRINGS = {"iostream": {"ostream", "istream", "ios"}, "sstream": {"string"}}
HOMES = {name: {header} for header, names in NAMES.items() for name in names.split()}
HOMES.update(NAMES_OF_SEVERAL)
WHOLE = {"chrono": "chrono", "filesystem": "filesystem", "numbers": "numbers"}
NESTED = {"chrono", "filesystem", "numbers", "ranges", "execution", "this_thread"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'(?=\W)', re.DOTALL)
USE = re.compile(r"\bstd::((?:(?:chrono|filesystem|numbers|ranges|execution|this_thread)::)?\w+)")


def without_comments(text):
    """The text with comments and literals emptied, lines kept."""
    return NOT_CODE.sub(lambda match: "\n" * match[0].count("\n"), text)


def own_header(file, text):
    """The header that a source implements: the first include, if it has the source's name."""
    first = INCLUDE.search(text)
    if file.suffix != ".cpp" or first is None or Path(first[2]).stem != file.stem:
        return None
    bases = [file.parent, ROOT / "src", ROOT / "cli", ROOT, ROOT / "tests", ROOT / "include"]
    return next((base / first[2] for base in bases if (base / first[2]).is_file()), None)


def homes_of(name):
    """The headers of which any one gives the name; None where the name is not known."""
    outer, _, inner = name.partition("::")
    if inner and outer in WHOLE:
        return {WHOLE[outer]}
    return HOMES.get(name)


def missing_headers(file):
    """The headers that the file lacks: header -> (first line, a name that it is needed for)."""
    text = file.read_text(encoding="utf-8")
    included = {match[2] for match in INCLUDE.finditer(text) if match[1] == "<"}
    header = own_header(file, text)
    if header is not None:
        included |= {match[2] for match in INCLUDE.finditer(header.read_text(encoding="utf-8"))}
    for name in list(included):
        included |= BRINGS.get(name, set())
    missing = {}
    for number, line in enumerate(without_comments(text).splitlines(), 1):
        for name in USE.findall(line):
            homes = homes_of(name)
            if homes is not None and not homes & included:
                missing.setdefault(sorted(homes)[0], (number, name))
    return missing


def mend(file, headers):
    """Inserts the headers into the sorted block of standard headers, or as a new block behind the
    last include that no condition guards."""
    lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
    new = [f"#include <{header}>\n" for header in headers]
    depth, last, block = 0, -1, []
    for k, line in enumerate(lines):
        depth += line.startswith("#if") - line.startswith("#endif")
        if depth == 0 and line.startswith(("#include", "#pragma once")):
            last = k
            if re.match(r"#include <\w+>", line) and (not block or block[-1] == k - 1):
                block.append(k)
    if block:
        first, end = block[0], block[-1] + 1
        lines[first:end] = sorted(lines[first:end] + new)
    else:
        lines[last + 1:last + 1] = ["\n"] + sorted(new)
    file.write_text("".join(lines), encoding="utf-8")


def main():
    arguments = sys.argv[1:]
    mending = "--mend" in arguments
    files = [Path(name).resolve() for name in arguments if name != "--mend"]
    if not files:
        files = [f for folder in FOLDERS for f in sorted((ROOT / folder).rglob("*.[ch]pp"))]
    faults, most = 0, Counter()
    for file in files:
        if file.stem.endswith("-inl"):
            continue  # included once for each instruction set, behind what includes it
        missing = missing_headers(file)
        for header, (number, name) in sorted(missing.items()):
            print(f"{file.relative_to(ROOT)}:{number}: std::{name} needs #include <{header}>")
            most[header] += 1
        faults += bool(missing)
        if mending and missing:
            mend(file, missing)
    if faults:
        print(f"{faults} of {len(files)} files lack standard headers "
              f"({', '.join(f'{header} {count}' for header, count in most.most_common(8))}); "
              "--mend inserts them", file=sys.stderr)
    return 1 if faults and not mending else 0


if __name__ == "__main__":
    sys.exit(main())
