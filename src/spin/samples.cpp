#include "spin/samples.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "rotation/text.hpp"

namespace rotor {
namespace {

std::string place(std::size_t row, std::size_t line) {
  return "row " + std::to_string(row) + (line == 0 ? "" : " (line " + std::to_string(line) + ")");
}

// The first few, and that there are more.
std::string first_of(const std::vector<std::string>& items) {
  constexpr std::size_t kShown = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(kShown, items.size()); ++i)
    list += (i == 0 ? "" : "; ") + items[i];
  return list + (items.size() > kShown ? "; ..." : "");
}

// "3 rows".
std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

bool is_finite(const Sample& sample) { return std::isfinite(sample.t) && sample.omega.allFinite(); }

// Each of these works on the rows that those before it have left, and appends what it found.

void take_missing(std::vector<Sample>& rows, bool accepted, std::vector<std::string>& complaints) {
  std::vector<std::string> found;
  for (const Sample& sample : rows) {
    if (!is_finite(sample)) {
      found.push_back(place(sample.row, sample.line) + " t = " + text(sample.t) + ", omega " +
                      text(sample.omega));
    }
  }
  if (found.empty()) return;
  if (!accepted) {
    complaints.push_back(counted(found.size(), "row") + " with a number missing, or not finite: " +
                         first_of(found) + " (missing = \"skip\" leaves out such rows)");
  }
  std::erase_if(rows, [](const Sample& sample) { return !is_finite(sample); });
}

void sort_rows(std::vector<Sample>& rows, bool accepted, std::vector<std::string>& complaints) {
  std::vector<std::string> found;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].t < rows[i - 1].t) {
      found.push_back(place(rows[i].row, rows[i].line) + " t = " + text(rows[i].t) + " after " +
                      text(rows[i - 1].t));
    }
  }
  if (found.empty()) return;
  if (!accepted) {
    complaints.push_back("the time goes back " + counted(found.size(), "time") + ": " +
                         first_of(found) + " (order = \"sort\" sorts the rows)");
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Sample& a, const Sample& b) { return a.t < b.t; });
}

void merge_duplicates(std::vector<Sample>& rows, Cleaning::Duplicates accepted,
                      std::vector<std::string>& complaints) {
  std::vector<std::string> found;
  std::vector<Sample> merged;
  merged.reserve(rows.size());
  std::size_t count = 0;  // rows at the time of merged.back()
  for (const Sample& sample : rows) {
    if (merged.empty() || merged.back().t != sample.t) {
      merged.push_back(sample);
      count = 1;
      continue;
    }
    found.push_back(place(sample.row, sample.line) + " t = " + text(sample.t) + " as row " +
                    std::to_string(merged.back().row));
    ++count;
    if (accepted == Cleaning::Duplicates::kMean)
      merged.back().omega += (sample.omega - merged.back().omega) / static_cast<double>(count);
  }
  if (found.empty()) return;
  if (accepted == Cleaning::Duplicates::kRefuse) {
    complaints.push_back(counted(found.size(), "row") +
                         " with the time of another: " + first_of(found) +
                         R"( (duplicates = "first" or "mean" makes one row of them))");
  }
  rows = std::move(merged);
}

}  // namespace

std::string said_of(const Samples& samples, const std::string& message) {
  return samples.name.empty() ? message : samples.name + ": " + message;
}

Samples cleaned(Samples samples, const Cleaning& cleaning) {
  std::vector<std::string> complaints;
  take_missing(samples.rows, cleaning.skip_missing, complaints);
  sort_rows(samples.rows, cleaning.sort, complaints);
  merge_duplicates(samples.rows, cleaning.duplicates, complaints);
  if (!complaints.empty()) {
    std::string all;
    for (const std::string& complaint : complaints) all += (all.empty() ? "" : "; ") + complaint;
    throw std::invalid_argument(said_of(samples, all));
  }
  if (samples.rows.size() < 2) {
    throw std::invalid_argument(
        said_of(samples, "expected at least two rows, got " + std::to_string(samples.rows.size())));
  }
  if (!std::isfinite(samples.rows.back().t - samples.rows.front().t)) {
    throw std::invalid_argument(said_of(samples, "the times " + text(samples.rows.front().t) +
                                                     " .. " + text(samples.rows.back().t) +
                                                     " are further apart than the largest number"));
  }
  return samples;
}

double usual_interval(const Samples& samples) {
  std::vector<double> intervals;
  intervals.reserve(samples.rows.size());
  for (std::size_t i = 1; i < samples.rows.size(); ++i)
    intervals.push_back(samples.rows[i].t - samples.rows[i - 1].t);
  const auto middle = intervals.begin() + std::ssize(intervals) / 2;
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

std::vector<Gap> gaps(const Samples& samples, double factor) {
  if (!(factor >= 1)) {
    throw std::invalid_argument("gap: expected a number of usual intervals, 1 or more, got " +
                                text(factor));
  }
  const double longest = factor * usual_interval(samples);
  std::vector<Gap> found;
  for (std::size_t i = 1; i < samples.rows.size(); ++i) {
    const Sample& before = samples.rows[i - 1];
    const Sample& after = samples.rows[i];
    if (after.t - before.t > longest) found.push_back({before.row, before.line, before.t, after.t});
  }
  return found;
}

std::string report_of(const std::vector<Gap>& gaps, const Samples& samples, double factor) {
  if (gaps.empty()) return {};
  std::vector<std::string> items;
  items.reserve(gaps.size());
  for (const Gap& gap : gaps) {
    items.push_back("after " + place(gap.row, gap.line) + ", t = " + text(gap.from) + " .. " +
                    text(gap.to));
  }
  return said_of(samples, counted(gaps.size(), "interval") + " longer than " + text(factor, 4) +
                              " times the usual " + text(usual_interval(samples), 4) + ": " +
                              first_of(items));
}

}  // namespace rotor
