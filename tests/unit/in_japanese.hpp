#pragma once
/// \file
/// A piece of a test that runs in Japanese.

#include "words/words.hpp"

/// Texts are Japanese as long as this lives, and English after it.
struct InJapanese {
  InJapanese() { gg::setLanguage(gg::Language::japanese); }
  ~InJapanese() { gg::setLanguage(gg::Language::english); }
  InJapanese(const InJapanese&) = delete;
  InJapanese& operator=(const InJapanese&) = delete;
};
