/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Contributing authors: LBM-IBB developers
------------------------------------------------------------------------- */

// Restart files of fix lb/ibb: how they are named and found, and which are refused. That runs go on

// Files that fix lb/ibb/vtk writes: what is in them is what the fluid and the grains have.

#include "fluid_scenes.h"
#include "vtk_file.h"

#include "comm.h"
#include "lbm_vtk.h"
#include "update.h"

#include <filesystem>
#include <regex>

class VtkFiles : public FluidTest {
 protected:
  static std::vector<std::string> encodings()
  {
    if (lbm::vtk_has_zlib()) return {"zlib", "raw", "base64"};
    return {"raw", "base64"};
  }
  static bool exists(const std::string &name) { return std::filesystem::exists(name); }

  std::string scene(const std::string &options = "every 2")
  {
    return box({12, 11, 10}, "p p f", "timestep " + num(DT / 2)) +
        grain(1, {0.4, 6.1, 4.9}, 2.6, {2e-3, 0, 1e-3}) + grain(2, {6.2, 3.8, 6.1}, 2.2) +
        "\nset atom 2 type 2\nfix m all nve/sphere\ntimestep " + num(DT / 2) +
        fluid("accel 1e-3 2e-3 0 face zlo wall face zhi wall " + options);
  }
  static std::string vtk(const std::string &options, const std::string &id = "v")
  {
    return "\nfix " + id + " all lb/ibb/vtk " + options;
  }

  // every field of a file at every node it has; region or stride have left these nodes
  void expect_fields(const std::string &name, const Cells &first, const Cells &count, int stride)
  {
    SCOPED_TRACE(name);
    const VtkReader file(name);
    for (const std::string field : {"density", "pressure", "velocity", "solid"}) {
      const int columns = field == "velocity" ? 3 : 1;
      const auto found = file.array(field);
      ASSERT_EQ(found.size(), std::size_t(count[0]) * count[1] * count[2] * columns) << field;
      for (int c = 0; c < columns; c++) {
        const auto all = values(field.c_str(), c);
        std::size_t k = c;
        for (int z = 0; z < count[2]; z++)
          for (int y = 0; y < count[1]; y++)
            for (int x = 0; x < count[0]; x++, k += columns)
              ASSERT_EQ(found[k],
                        float(all[place({first[0] + x * stride, first[1] + y * stride,
                                         first[2] + z * stride})]))
                  << field << " " << x << " " << y << " " << z;
      }
    }
    const auto extent = file.numbers("ImageData", "WholeExtent");
    EXPECT_EQ(extent, file.numbers("Piece", "Extent"));
    const auto origin = file.numbers("ImageData", "Origin");
    const auto spacing = file.numbers("ImageData", "Spacing");
    for (int d = 0; d < 3; d++) {
      EXPECT_EQ(extent[2 * d], 0.0);
      EXPECT_EQ(extent[2 * d + 1], count[d] - 1.0);
      const double at = n[2] == 1 && d == 2 ? 0.0 : (first[d] + 0.5) * DX;
      EXPECT_NEAR(origin[d], at, 1e-9 * DX);
      EXPECT_NEAR(spacing[d], stride * DX, 1e-9 * DX);
    }
  }
};

TEST_F(VtkFiles, ShowTheFieldsInEveryEncoding)
{
  for (const std::string &encoding : encodings()) {
    start();
    script(
        scene() +
        vtk("20 w a_" + encoding + " fields density pressure velocity solid encoding " + encoding) +
        run(20));
    const std::string name = "a_" + encoding + "-fluid-000000020.vti";
    expect_fields(name, {0, 0, 0}, {12, 11, 10}, 1);
    EXPECT_NEAR(VtkReader(name).time(), 20 * DT / 2, 1e-12 * DT);
    EXPECT_GT(out(9), 0.0);     // something flows
    EXPECT_GT(out(13), 0.0);    // around grains
    EXPECT_FALSE(exists(name + ".part"));
  }
}

TEST_F(VtkFiles, RegionAndStride)
{
  // faces of the region: on nodes along x, on cell faces along y, nowhere along z
  script(scene() + "\nregion some block 1.5e-4 9.5e-4 2e-4 9e-4 -1 0.71e-3\nregion all block INF " +
         "INF INF INF INF INF\nregion slice block INF INF 5e-4 6e-4 INF INF" +
         vtk("20 w b fields density pressure velocity solid region some", "b") +
         vtk("20 w c fields density pressure velocity solid region some stride 3", "c") +
         vtk("20 w d fields density pressure velocity solid region all stride 2", "d") +
         vtk("20 w e fields density pressure velocity solid region slice", "e") + run(20));
  expect_fields("b-fluid-000000020.vti", {1, 2, 0}, {9, 7, 7}, 1);
  expect_fields("c-fluid-000000020.vti", {1, 2, 0}, {3, 3, 3}, 3);
  expect_fields("d-fluid-000000020.vti", {0, 0, 0}, {6, 6, 5}, 2);
  expect_fields("e-fluid-000000020.vti", {0, 5, 0}, {12, 1, 10}, 1);
  // what reaches into the box of the region: grain 1 from x = -2.2 to 3, grain 2 from 4 to 8.4
  script("region left block INF 3.5e-4 INF INF INF INF\nregion gap block 3.2e-4 3.8e-4 INF INF " +
         std::string("INF INF") + vtk("20 w f region left stride 2", "f") +
         vtk("20 w g region gap", "g") + run(20));
  EXPECT_EQ(VtkReader("f-grains-000000040.vtp").array("id"), (std::vector<double>{1}));
  EXPECT_EQ(VtkReader("g-grains-000000040.vtp").array("id").size(), 0u);
}

TEST_F(VtkFiles, TwoDimensions)
{
  script(box({14, 12, 1}) + disc(1, {6.3, 5.8, 0.0}, 3.3, {1e-3, 0, 0}) +
         "\nfix m all nve/sphere disc" + fluid("accel 1e-3 0 0") +
         vtk("10 w a fields density pressure velocity solid") + run(10));
  expect_fields("a-fluid-000000010.vti", {0, 0, 0}, {14, 12, 1}, 1);
  EXPECT_EQ(VtkReader("a-grains-000000010.vtp").array("points")[2], 0.0);
}

TEST_F(VtkFiles, ShowTheGrains)
{
  for (const std::string &encoding : encodings()) {
    start();
    script(scene() + "\ngroup odd id 2\nvelocity all set 0 0 -0.01 sum yes units box" +
           vtk("20 w a encoding " + encoding) +
           "\nfix one odd lb/ibb/vtk 20 w one fields none encoding " + encoding + run(20));
    const VtkReader file("a-grains-000000020.vtp"), one("one-grains-000000020.vtp");
    EXPECT_EQ(file.attribute("Piece", "NumberOfPoints"), "2");
    EXPECT_EQ(file.array("connectivity"), (std::vector<double>{0, 1}));
    EXPECT_EQ(file.array("offsets"), (std::vector<double>{1, 2}));
    EXPECT_EQ(file.array("id"), (std::vector<double>{1, 2}));
    EXPECT_EQ(file.array("type"), (std::vector<double>{1, 2}));
    EXPECT_EQ(file.array("radius"), (std::vector<double>{radius(1), radius(2)}));
    for (int k : {0, 1}) {
      const int id = k ? 2 : 1;
      for (int d = 0; d < 3; d++) {
        const double away = file.array("points")[3 * k + d] - x(id)[d];
        EXPECT_NEAR(away - n[d] * DX * std::nearbyint(away / (n[d] * DX)), 0.0, 1e-9 * DX);
        EXPECT_GE(file.array("points")[3 * k + d], 0.0);
        EXPECT_LE(file.array("points")[3 * k + d], n[d] * DX);
        EXPECT_EQ(file.array("velocity")[3 * k + d], v(id)[d]);
        EXPECT_EQ(file.array("omega")[3 * k + d], omega(id)[d]);
        EXPECT_EQ(file.array("force")[3 * k + d], load(id)[d]);
        EXPECT_EQ(file.array("torque")[3 * k + d], load(id)[3 + d]);
      }
    }
    EXPECT_NE(file.array("force")[2], 0.0);
    EXPECT_EQ(one.array("id"), (std::vector<double>{2}));
    EXPECT_EQ(one.array("velocity")[2], v(2)[2]);
    EXPECT_FALSE(exists("one-fluid.pvd"));
  }
}

TEST_F(VtkFiles, AnEmptyBox)
{
  script(box({8, 8, 8}) + fluid("accel 1e-3 0 0") + vtk("10 w a") + run(10));
  const VtkReader file("a-grains-000000010.vtp");
  EXPECT_EQ(file.attribute("Piece", "NumberOfPoints"), "0");
  EXPECT_EQ(file.array("points").size(), 0u);
}

// ---- lists of files

static std::string list_of(const std::string &name, const std::vector<int> &steps, double dt)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
                     "<Collection>\n";
  for (int step : steps) {
    char line[200];
    snprintf(line, sizeof line, "<DataSet timestep=\"%.12g\" part=\"0\" file=\"%s-%09d.vti\"/>\n",
             step * dt, name.c_str(), step);
    text += line;
  }
  return text + "</Collection>\n</VTKFile>\n";
}

TEST_F(VtkFiles, ListsGiveTheTimes)
{
  const double dt = DT / 2;
  script(scene() + vtk("4 w a") + run(10));
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 4, 8}, dt));
  script("run 0 post no\nrun 2 post no\nrun 0 post no\nrun 3 post no");    // each state once
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 4, 8, 12}, dt));
  EXPECT_TRUE(exists("a-grains.pvd"));
}

TEST_F(VtkFiles, GoOnAfterARestart)
{
  const double dt = DT / 2;
  const std::string moving = "\nfix m all nve/sphere",
                    again =
                        fluid("accel 1e-3 2e-3 0 face zlo wall face zhi wall every 2 restart at10");
  script(scene() + vtk("4 w a") + run(10) + "\nwrite_restart at10\nrestart 12 mid.*" +
         run(11));    // and is killed
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 4, 8, 12, 16, 20}, dt));
  std::filesystem::remove("a-fluid-000000004.vti");    // somebody tidied up
  start();
  script("read_restart at10\nneighbor 1e-4 bin" + moving + again + vtk("4 w a") + run(0));
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 4, 8, 12, 16, 20}, dt));
  script("run 3 post no");
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 8, 12}, dt));
  // at the step of an output that is there: not once more
  script("run 3 post no\nwrite_restart at10");
  std::filesystem::last_write_time("a-fluid-000000016.vti", {});
  start();
  script("read_restart at10\nneighbor 1e-4 bin" + moving + again + vtk("4 w a") + run(4));
  EXPECT_EQ(std::filesystem::last_write_time("a-fluid-000000016.vti"),
            std::filesystem::file_time_type{});
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 8, 12, 16, 20}, dt));
  // from a file of mid-run, too
  start();
  script("read_restart mid.12\nneighbor 1e-4 bin" + moving +
         std::regex_replace(again, std::regex("at10"), "mid.12") + vtk("4 w a") + run(4));
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {0, 8, 12, 16}, dt));
  EXPECT_NEAR(VtkReader("a-fluid-000000016.vti").time(), 16 * dt, 1e-12 * dt);
  // another fix, of another ID: a new series
  start();
  script("read_restart at10\nneighbor 1e-4 bin" + moving + again + vtk("4 w a", "other") + run(4));
  EXPECT_EQ(VtkReader::text_of("a-fluid.pvd"), list_of("a-fluid", {16, 20}, dt));
  // with another timestep, for a fluid that starts anew: time goes on from where it was
  start();
  script("read_restart at10\nneighbor 1e-4 bin\ntimestep " + num(dt / 2) + moving +
         std::regex_replace(again, std::regex("every 2 restart at10"), "every 4 restart none") +
         vtk("4 w a") + run(4));
  EXPECT_NEAR(VtkReader("a-fluid-000000020.vti").time(), 18 * dt, 1e-12 * dt);
}

// ---- refusals

TEST_F(VtkFiles, BadInputIsRefused)
{
  const std::string good = scene();
  auto refused = [&](const std::string &options, const std::string &why) {
    start();
    EXPECT_ERROR(good + vtk(options), why);
  };
  refused("20 w", "Illegal fix lb/ibb/vtk command: missing argument");
  refused("0 w a", "every 0 time steps: at least 1 is needed");
  refused("20 w a&b", "name 'a&b' has a & in it, which XML keeps for itself: use letters");
  refused("5 w a", "every 5 time steps, but the fluid moves every 2: use 4 or 6");
  refused("1 w a", "every 1 time steps, but the fluid moves every 2: use 2");
  refused("20 water a", "there is no fix lb/ibb with ID water: define it before this fix");
  refused("20 m a", "there is no fix lb/ibb with ID m");
  refused("20 w a stride 0", "stride 0: at least 1 is needed");
  refused("20 w a stride", "missing argument");
  refused("20 w a stride 2 stride 3", "'stride' is given twice");
  refused("20 w a strides 2", "unknown keyword 'strides'");
  refused("20 w a fields", "missing argument");
  refused("20 w a fields stride 2", "names of fields must follow, or none");
  refused("20 w a fields velocity speed", "no field 'speed': it has density, pressure, velocity");
  refused("20 w a fields velocity velocity", "field velocity is named twice");
  refused("20 w a fields velocity none", "no field 'none'");
  refused("20 w a fields none grains no", "neither fields nor grains");
  refused("20 w a encoding ascii", "encoding 'ascii' is none of zlib, raw, base64");
  refused("20 w a region nowhere", "there is no region nowhere");
  refused("20 w a" + vtk("20 w a", "v2"), "fix v writes files of that name already");
  refused(
      "20 w a\nregion r block 0 1e-3 0 1e-3 3.6e-4 4.4e-4" + vtk("20 w b region r", "v2"),
      "region r holds no node along z: it reaches from 0.00036 to 0.00044; nodes are at 5e-05 + "
      "k 0.0001, k = 0 to 9");
  refused("20 w a\nregion r block 0 1e-3 2 3 0 1e-3" + vtk("20 w b region r", "v2"),
          "region r holds no node along y");
  refused("20 w a\nregion r block 0 1e-3 0 1e-3 0 1e-3 side out" + vtk("20 w b region r", "v2"),
          "region r has no bounding box");
  refused("20 w a\nvariable z equal 0\nregion r block 0 1e-3 0 1e-3 0 1e-3 move v_z NULL NULL" +
              vtk("20 w b region r", "v2"),
          "region r moves or changes");
  refused("20 w nowhere/a" + run(0), "cannot open nowhere/a-fluid-000000000.vti.part");
  refused("20 w a\nunfix w" + run(0), "there is no fix lb/ibb with ID w");
  if (!lbm::vtk_has_zlib()) refused("20 w a encoding zlib", "built without zlib");
  start();
  EXPECT_ERROR(good + vtk("20 w a") + "\nunfix w" + fluid("face zlo wall face zhi wall") + run(0),
               "fix w was defined anew after this fix");
}

// without a fluid's pass over its nodes there would be pictures of what no run may go on with
TEST_F(VtkFiles, NothingIsShownOfAFluidThatBlewUp)
{
  EXPECT_ERROR(box({8, 8, 8}) + fluid("check 100000 accel v_a 0 0") + vtk("10 w a") +
                   "\nvariable a equal 40*(step>11)" + run(20),
               "stopped at step");
  EXPECT_FALSE(exists("a-fluid-000000020.vti"));
  EXPECT_TRUE(exists("a-fluid-000000010.vti"));
}
