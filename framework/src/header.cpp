// Stands for <gg/gg.hpp> alone, so that the header is compiled once for all programs.
