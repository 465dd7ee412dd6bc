#pragma once

#include <string>
#include <vector>

#include "report/gnuplot.hpp"

namespace ligament {

/// Load over a displacement of the runs of an ensemble, and of their means. Tables are named as gnuplot finds them.
struct EnsemblePicture {
  struct Group {
    std::string title;
    std::string mean;               ///< table with the columns of curve.csv
    std::vector<std::string> runs;  ///< tables of the runs
  };

  std::string abscissa;  ///< column in m
  std::string load;      ///< column in N
  double largest_x = 0.0;
  double largest_y = 0.0;
  std::vector<Group> groups;  ///< runs with the same values
};

/// All runs in grey, and for every group its mean as a line in a band from the least to the largest load.
Figure ensemble_figure(const EnsemblePicture& picture);

}  // namespace ligament
