// SPDX-License-Identifier: Apache-2.0
// What the sanitizers must not blame us for in programs that use Fast DDS 2.9; link it into them.

/// Its statistics objects are deleted through a base without virtual destructor.
extern "C" const char* __asan_default_options() { return "new_delete_type_mismatch=0"; }

/// It is not instrumented: what it does with its own mutexes cannot be judged from outside.
extern "C" const char* __tsan_default_suppressions() {
  return "mutex:libfastrtps.so\ndeadlock:libfastrtps.so\n";
}
