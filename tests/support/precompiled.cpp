// No code: CMake compiles the headers that the tests share with the options of some source file.
