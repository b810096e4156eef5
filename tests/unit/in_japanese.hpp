#pragma once

#include "words/words.hpp"

/// What is said while this lives is Japanese.
struct InJapanese {
  InJapanese() { gg::setLanguage(gg::Language::japanese); }
  ~InJapanese() { gg::setLanguage(gg::Language::english); }
  InJapanese(const InJapanese&) = delete;
  InJapanese& operator=(const InJapanese&) = delete;
};
