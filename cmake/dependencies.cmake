# What Boomwatch is built on, all from Debian 12.
#
# Debian's VTK is built with Qt 5. It is found here without its Qt module, and PCL is then
# kept from finding it again with that module, so that Qt 5 never enters a Qt 6 program.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs calib3d features2d
  tracking video videoio)
find_package(Threads REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
if(BOOMWATCH_GUI)
  find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel RenderingCore RenderingOpenGL2)
endif()
set(CMAKE_DISABLE_FIND_PACKAGE_VTK TRUE)
find_package(PCL REQUIRED COMPONENTS common io kdtree search filters)
if(BOOMWATCH_GUI OR BOOMWATCH_TESTS)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Core Test)
endif()
if(BOOMWATCH_GUI)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Gui Widgets OpenGL OpenGLWidgets Svg LinguistTools)
endif()
