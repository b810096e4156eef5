// A C++20 program: threads, files, exceptions and clocks work inside.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <stdexcept>
#include <thread>

int main() {
  int sum = 0;
  std::jthread(
      [&](std::span<const int> numbers) {
        for (const int number : numbers) sum += number;
      },
      std::initializer_list<int>{1, 2, 3})
      .join();
  try {
    throw std::runtime_error("caught");
  } catch (const std::exception& error) {
    std::ofstream("/scratch/note") << error.what();
  }
  std::filesystem::copy_file("/scratch/note", "/tmp/note");
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::cout << "hello " << sum << ' ' << std::filesystem::file_size("/tmp/note") << '\n';
}
