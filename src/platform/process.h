// This program's file, and programs that it starts.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace rc_platform {

std::string own_program();  // path of the file of the program that runs, UTF-8; "" if the system does not say

struct Ended {
  int code = -1;         // what the program returned; -1 if it did not run or was killed
  bool missing = false;  // there is no such program
  std::string error;     // why it did not run; "" if it did
};

// Runs a program found as a shell finds it, with these open files as its standard streams, to its end. What is typed to interrupt
// this program does not reach it.
Ended run(const std::string& program, const std::vector<std::string>& arguments, std::FILE* input, std::FILE* output,
          std::FILE* errors);

// Runs a program found as a shell finds it in the place of this one, and returns only if it cannot. Where a system has no such
// call, it runs beside this one, with its streams, to its end.
Ended become(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace rc_platform
