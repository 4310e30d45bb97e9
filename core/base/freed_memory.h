#pragma once

namespace boomwatch {

/// For a program that processes frames: what is freed stays with it. Clouds and images of megabytes
/// are made anew for every frame; to get their pages from the system again each time takes a tenth
/// of the frame. Call it first in main(). Does nothing but where the C library is glibc.
void keepFreedMemory();

}  // namespace boomwatch
