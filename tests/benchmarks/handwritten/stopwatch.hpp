// Processor time of this thread [s]: what other programs on the machine do does not count.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

inline double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

// Median time of an action repeated so many times, 0 for none.
template <class Action>
double median_seconds(int repeats, Action action) {
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const double begin = cpu_seconds();
    action();
    seconds.push_back(cpu_seconds() - begin);
  }
  std::sort(seconds.begin(), seconds.end());
  return repeats ? seconds[repeats / 2] : 0;
}
