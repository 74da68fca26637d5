#include "system/machine.h"

#include <filesystem>
#include <fstream>
#include <sched.h>
#include <string>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "system/child_process.h"
#include "system/control_groups.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

TEST(Machine, HasTheCoresOfTheAffinity) {
  EXPECT_GE(coreCount(), 1);
  EXPECT_LE(coreCount(), static_cast<int>(std::thread::hardware_concurrency()));
  const auto pinned = [] {
    cpu_set_t all, one;
    CPU_ZERO(&one);
    if (sched_getaffinity(0, sizeof all, &all) != 0) _exit(100);
    int first = 0;
    while (!CPU_ISSET(first, &all)) ++first;
    CPU_SET(first, &one);
    if (sched_setaffinity(0, sizeof one, &one) != 0) _exit(101);
    _exit(coreCount());
  };
  EXPECT_EQ(ChildProcess::copy(pinned).wait().status, 1);
}

TEST(Machine, HasMemory) {
  EXPECT_GT(memorySize(), 1e8);
  EXPECT_LE(memorySize(), static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                              static_cast<double>(sysconf(_SC_PAGESIZE)));
}

/// A machine's files, in a folder of the running test.
class ControlGroups : public ::testing::Test {
 protected:
  ControlGroups() { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& content) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << content;
  }

  /// As on a machine with systemd: this process is in `group` of the one hierarchy, whose top the
  /// mount shows as `top`.
  void useVersion2(const std::string& group, const std::string& top) const {
    write("proc/self/cgroup", "0::" + group + '\n');
    write("proc/self/mountinfo",
          "22 1 8:1 / / rw,relatime shared:1 - ext4 /dev/sda1 rw\n"
          "30 22 0:27 " +
              top + " /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n");
  }

  const fs::path root_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "control_groups" /
                         ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ControlGroups, SetNoLimitWhereThereAreNone) {
  EXPECT_EQ(controlGroupLimits(root_).cores, std::nullopt);
  useVersion2("/", "/");
  EXPECT_EQ(controlGroupLimits(root_).memory, std::nullopt);
  write("sys/fs/cgroup/cpu.max", "max 100000\n");
  write("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(controlGroupLimits(root_).cores, std::nullopt);
  EXPECT_EQ(controlGroupLimits(root_).memory, std::nullopt);
}

TEST_F(ControlGroups, SetTheLowestLimitAboveAProcess) {
  useVersion2("/slurm/job_7/task_0", "/");
  write("sys/fs/cgroup/slurm/cpu.max", "800000 100000\n");
  write("sys/fs/cgroup/slurm/job_7/cpu.max", "150000 100000\n");
  write("sys/fs/cgroup/slurm/job_7/task_0/cpu.max", "max 100000\n");
  write("sys/fs/cgroup/slurm/job_8/cpu.max", "50000 100000\n");
  write("sys/fs/cgroup/slurm/job_7/memory.max", "2000000000\n");
  write("sys/fs/cgroup/slurm/job_7/task_0/memory.max", "1000000000\n");
  EXPECT_EQ(controlGroupLimits(root_).cores, 1.5);
  EXPECT_EQ(controlGroupLimits(root_).memory, 1e9);
}

// Its own name is that of the machine, or none.
TEST_F(ControlGroups, AreFoundInAContainer) {
  write("sys/fs/cgroup/cpu.max", "200000 100000\n");
  for (const std::string group : {"/", "/docker/12ab"}) {
    useVersion2(group, group);
    EXPECT_EQ(controlGroupLimits(root_).cores, 2) << group;
  }
}

TEST_F(ControlGroups, OfVersion1HaveAHierarchyForEachResource) {
  write("proc/self/cgroup", "9:memory:/job\n4:cpu,cpuacct:/job\n1:name=systemd:/x\n0::/\n");
  write("proc/self/mountinfo",
        "31 30 0:28 / /sys/fs/cgroup/cpu,cpuacct rw,relatime - cgroup cgroup rw,cpu,cpuacct\n"
        "34 30 0:31 / /sys/fs/cgroup/memory rw,relatime - cgroup cgroup rw,memory\n"
        "36 30 0:35 / /sys/fs/cgroup/systemd rw,relatime - cgroup cgroup rw,name=systemd\n");
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
  write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "300000\n");
  write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "4000000000\n");
  EXPECT_EQ(controlGroupLimits(root_).cores, 3);
  EXPECT_EQ(controlGroupLimits(root_).memory, 4e9);
}

TEST_F(ControlGroups, AreTakenAsTheyCome) {
  useVersion2("/a/../../b", "/");
  write("sys/fs/cgroup/cpu.max", "nonsense\n");
  write("sys/fs/cgroup/memory.max", "0\n");
  EXPECT_EQ(controlGroupLimits(root_).cores, std::nullopt);
  EXPECT_EQ(controlGroupLimits(root_).memory, std::nullopt);
}

}  // namespace
}  // namespace rotatebook::system
