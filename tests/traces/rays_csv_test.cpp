#include "traces/rays_csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/traces/support.h"

namespace cuesta {
namespace {

const std::string kTitle = "# cuesta rays 1, width 4, height 2\n";
const std::string kNames = "id,origin_u,origin_v,origin_z,direction_u,direction_v,direction_z";

TEST(RaysCsv, EveryFieldComesBackBitForBit) {
  ScratchFolder folder;
  const RayTrace trace = any_trace(11, 5000);
  write_rays_csv(folder.file("a.csv"), trace);
  EXPECT_TRUE(identical(trace, read_rays_csv(folder.file("a.csv"))));
  EXPECT_EQ(folder.files(), 1u);
}

TEST(RaysCsv, ColumnsMayStandInAnyOrderAndBeLeftOut) {
  ScratchFolder folder;
  write_bytes(folder.file("a.csv"), kTitle + "kind,t_max,parent,direction_z," +
                                        "id,origin_u,origin_v,origin_z,direction_u,direction_v\r\n"
                                        "shadow,inf,3,-1,12,0.5,1e-3,-0,0,2\r\n");
  const RayTrace trace = read_rays_csv(folder.file("a.csv"));
  EXPECT_EQ(trace.width, 4);
  EXPECT_EQ(trace.height, 2);
  ASSERT_EQ(trace.rays.size(), 1u);
  TracedRay expected;
  expected.id = 12;
  expected.kind = RayKind::kShadow;
  expected.parent = 3;
  expected.origin[0] = 0.5;
  expected.origin[1] = 0.001;
  expected.origin[2] = -0.0;
  expected.direction[1] = 2;
  expected.direction[2] = -1;
  EXPECT_TRUE(identical(trace.rays[0], expected));
}

TEST(RaysCsv, ErrorsNameLineAndColumn) {
  ScratchFolder folder;
  const auto expect = [&](const std::string& bytes, const std::string& where, const std::string& what) {
    write_bytes(folder.file("a.csv"), bytes);
    const std::string sentence = sentence_of(ExitCode::kInput, [&] { read_rays_csv(folder.file("a.csv")); });
    EXPECT_NE(sentence.find("a.csv" + where), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(what), std::string::npos) << sentence;
  };
  const std::string head = kTitle + kNames;
  expect("", ":1:", "first line");
  expect("# cuesta rays 2, width 4, height 2\n", ":1:", "first line");
  expect("# cuesta rays 1, width 4, height -2\n", ":1:", "first line");
  expect("# cuesta rays 1, width 4, height 0\n", ":1:", "4 x 0");
  expect("# cuesta rays 1, width 4, height 70000\n", ":1:", "65536");
  expect(kTitle, ":2:", "columns");
  expect(kTitle + "id,origin_u,origin_v,origin_z,direction_u,direction_v\n", ":2:", "direction_z");
  expect(kTitle + kNames + ",orign_u\n", ":2:", "column 8");
  expect(kTitle + kNames + ",id\n", ":2:", "second");
  expect(head + "\n1,0,0,1,0,0,-1\n2,0,zero,1,0,0,-1\n", ":4:", "column 3 (origin_v) holds `zero`");
  expect(head + "\n1,0,0,1,0,0,-1 \n", ":3:", "column 7 (direction_z)");
  expect(head + "\n-1,0,0,1,0,0,-1\n", ":3:", "column 1 (id)");
  expect(head + "\n18446744073709551616,0,0,1,0,0,-1\n", ":3:", "column 1 (id)");
  expect(head + "\n1,0,0,1,0,0\n", ":3:", "6 fields");
  expect(head + "\n1,0,0,1,0,0,-1,0\n", ":3:", "8 fields");
  expect(head + "\n1,0,0,1,0,0,-1\n\n", ":4:", "column 1 (id)");
  expect(head + "\n1,nan,0,1,0,0,-1\n", ":3:", "not a finite number");
  expect(head + "\n1,0,0,1,0,0,inf\n", ":3:", "not a finite number");
  expect(head + "\n1,0,0,1,0,0,1e999\n", ":3:", "column 7");
  expect(head + "\n1,0,0,1,0,0,0\n", ":3:", "direction is zero");
  expect(head + ",kind\n1,0,0,1,0,0,-1,ternary\n", ":3:", "primary, shadow");
  expect(head + ",pixel_x\n1,0,0,1,0,0,-1,4\n", ":3:", "pixel (4, 0)");
  expect(head + "\n1,0,0,1,0,0,-1\n1,0,0,1,0,0,-1\n", "", "id 1");
  expect(head + std::string("\n1,0,\0,1,0,0,-1\n", 16), ":3:", "column 3");
  EXPECT_NE(sentence_of(ExitCode::kInput, [&] { read_rays_csv(folder.file("none")); }).find("no such file"),
            std::string::npos);
}

}  // namespace
}  // namespace cuesta
