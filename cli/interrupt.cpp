#include "interrupt.hpp"

#include "io/write/output_file.hpp"

#include <abut/error.hpp>

#include <csignal>

#include <unistd.h>

namespace abut::cli {
namespace {

constexpr int exit_code_of_interrupts = 130;

volatile std::sig_atomic_t interrupt_flag = 0;
volatile std::sig_atomic_t ends_at_once = 0;
volatile std::sig_atomic_t met[NSIG] = {};

extern "C" void note_interrupt(int signal) {
  interrupt_flag = 1;
  if (ends_at_once != 0) {
    constexpr char sentence[] = "abut: interrupted\n";
    if (write(STDERR_FILENO, sentence, sizeof sentence - 1) < 0) _exit(exit_code_of_interrupts);
    _exit(exit_code_of_interrupts);
  }
  if (met[signal] == 0) {
    met[signal] = 1;
    return;
  }
  io::remove_temporary_in_handler();
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // is held back until the handler ends
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
    // Without SA_RESTART: a read or write that blocks returns, and the flag is seen.
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

bool interrupted() noexcept {
  return interrupt_flag != 0;
}

void stop_if_interrupted() {
  if (interrupted()) throw Error(ErrorCode::cancelled, "interrupted");
}

InterruptsEndAtOnce::InterruptsEndAtOnce() : before_(ends_at_once) {
  ends_at_once = 1;
  // An interrupt before was only noted.
  if (!interrupted()) return;
  ends_at_once = before_;
  stop_if_interrupted();
}

InterruptsEndAtOnce::~InterruptsEndAtOnce() {
  ends_at_once = before_;
}

}  // namespace abut::cli
