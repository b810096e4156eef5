/* Opens libGL itself, as SDL and GLEW do, and asks it for functions in both ways. */
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <stdio.h>

typedef void (*Function)(void);
typedef Function (*GetProcAddress)(const unsigned char*);
typedef void (*ClearColor)(float, float, float, float);
typedef void (*Clear)(unsigned);

int main(void) {
  void* library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library || !glfwInit()) return 10;
  GLFWwindow* window = glfwCreateWindow(8, 8, "capture", NULL, NULL);
  glfwMakeContextCurrent(window);
  ClearColor clearColor = (ClearColor)dlsym(library, "glClearColor");
  GetProcAddress getProcAddress = (GetProcAddress)dlsym(library, "glXGetProcAddressARB");
  Clear clear = (Clear)getProcAddress((const unsigned char*)"glClear");
  printf("%d %d\n", getProcAddress((const unsigned char*)"glNoSuchFunction") == NULL,
         glfwGetProcAddress("strlen") == NULL);
  while (!glfwWindowShouldClose(window)) {
    clearColor(1, 0, 1, 1);
    clear(0x4000);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
  return 0;
}
