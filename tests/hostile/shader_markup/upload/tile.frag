#version 410 core
#error </pre><script>alert(1)</script><img src=x onerror=alert(2)>
void main() {}
