#version 410 core
// The pass "shadow" keeps depths only: nothing to write.

void main() {}
