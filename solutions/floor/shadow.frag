#version 410 core
// The pass "shadow" keeps depths only: nothing to write.

uniform vec3 uGlow; // drawObjects() sets it for every program; there is no colour to add it to

void main() {}
