// Signals that wait until a piece of work is whole.
#ifndef APPS_CLI_SIGNALS_BLOCKED_H_
#define APPS_CLI_SIGNALS_BLOCKED_H_

#include <csignal>
#include <initializer_list>

namespace tautline::cli {

/// Keeps signals waiting for the calling thread, and for threads that it starts, while it lives.
class SignalsBlocked {
 public:
  /// Blocks the signals with which `HandleSignals` ends the program.
  SignalsBlocked() : SignalsBlocked({SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {}

  /// Blocks these alone.
  SignalsBlocked(std::initializer_list<int> signals) {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : signals) sigaddset(&set, signal);
    pthread_sigmask(SIG_BLOCK, &set, &before_);
  }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace tautline::cli

#endif  // APPS_CLI_SIGNALS_BLOCKED_H_
