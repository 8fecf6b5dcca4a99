// unload PLUGIN: loads and unloads a plugin that detects in several threads, in the main thread and
// in others, which end before or after it is unloaded. Exit code 0 if all went well.

#include <future>
#include <iostream>
#include <thread>

#include <dlfcn.h>

namespace {

constexpr long contacts = 39999;

class Plugin {
 public:
  explicit Plugin(const char* path) : handle_(dlopen(path, RTLD_NOW | RTLD_LOCAL)) {}
  ~Plugin() {
    if (handle_ != nullptr) dlclose(handle_);
  }
  Plugin(const Plugin&) = delete;
  Plugin& operator=(const Plugin&) = delete;

  [[nodiscard]] bool is_right() const {
    if (handle_ == nullptr) return false;
    const auto call = reinterpret_cast<long (*)()>(dlsym(handle_, "contacts_of_a_row"));
    return call != nullptr && call() == contacts;
  }

 private:
  void* handle_;
};

bool in_a_thread_that_ends_first(const char* path) {
  const Plugin plugin(path);
  bool right = false;
  std::thread([&] { right = plugin.is_right(); }).join();
  return right;
}

/// Its helpers are there when the plugin is closed.
bool in_a_thread_that_ends_last(const char* path) {
  std::promise<bool> done;
  std::promise<void> closed;
  std::thread caller;
  bool right = false;
  {
    const Plugin plugin(path);
    caller = std::thread([&] {
      done.set_value(plugin.is_right());
      closed.get_future().wait();
    });
    right = done.get_future().get();
  }
  closed.set_value();
  caller.join();
  return right;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  bool right = true;
  for (int again = 0; again < 3; ++again) {
    right = right && in_a_thread_that_ends_first(argv[1]);
    right = right && in_a_thread_that_ends_last(argv[1]);
    right = right && Plugin(argv[1]).is_right();
  }
  if (!right) std::cerr << "unload: a plugin was not loaded, or was wrong\n";
  return right ? 0 : 1;
}
