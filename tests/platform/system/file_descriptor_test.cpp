#include "system/file_descriptor.h"

#include <array>
#include <chrono>
#include <fcntl.h>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace rotatebook::system {
namespace {

TEST(WriteAll, WaitsForRoomInAPipeThatDoesNotWaitItself) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const FileDescriptor from(ends[0]);
  FileDescriptor to(ends[1]);
  ASSERT_EQ(fcntl(to.number(), F_SETFL, O_NONBLOCK), 0);
  const std::string content(300'000, 'x');  // A pipe holds 65,536.
  std::string taken;
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::array<char, 4096> block{};
    for (ssize_t size = 0; (size = read(from.number(), block.data(), block.size())) > 0;)
      taken.append(block.data(), static_cast<std::size_t>(size));
  });
  EXPECT_NO_THROW(writeAll(to, content, "the pipe"));
  { const FileDescriptor closed(std::move(to)); }
  reader.join();
  EXPECT_TRUE(taken == content);
}

}  // namespace
}  // namespace rotatebook::system
