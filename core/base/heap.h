#pragma once

namespace fumage {

/// Has the heap of this process stay small: before any thread starts. Threads share a few pools of memory instead of
/// keeping some of their own, and what is as large as a picture is the system's again as soon as it is freed. glibc
/// only.
void keepHeapSmall();

/// Gives memory that is free back to the system, which else keeps it for this process. Any thread; tens of
/// milliseconds. glibc only.
void giveBackMemory();

} // namespace fumage
