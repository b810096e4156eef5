#pragma once
/// \file
/// The message of the exception that a piece of code must throw.

#include <string>

#include <gtest/gtest.h>

/// Runs `code`; the message of the `Error` that it throws, or a test failure.
template <class Error, class Code> std::string messageOf(Code&& code) {
  try {
    code();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}
