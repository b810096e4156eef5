#include "open_window.hpp"

int main() {
  return openWindow(8, 8) ? 0 : 1;
}
