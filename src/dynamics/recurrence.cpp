#include "dynamics/recurrence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "dynamics/pair_distances.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kMostPairs = 1e10;

// How many lines there are of each length.
class LineLengths {
 public:
  explicit LineLengths(std::size_t longest) : count_(longest + 1) {}
  void add(std::size_t length) { ++count_[length]; }

  double points(std::size_t least) const {
    double sum = 0;
    for (std::size_t l = least; l < count_.size(); ++l)
      sum += static_cast<double>(l) * static_cast<double>(count_[l]);
    return sum;
  }
  double lines(std::size_t least) const {
    double sum = 0;
    for (std::size_t l = least; l < count_.size(); ++l) sum += static_cast<double>(count_[l]);
    return sum;
  }
  std::size_t longest(std::size_t least) const {
    for (std::size_t l = count_.size(); l-- > least;)
      if (count_[l] > 0) return l;
    return 0;
  }
  double entropy(std::size_t least) const {
    const double all = lines(least);
    double sum = 0;
    for (std::size_t l = least; l < count_.size(); ++l) {
      const double p = static_cast<double>(count_[l]) / all;
      if (count_[l] > 0) sum -= p * std::log(p);
    }
    return sum;
  }

 private:
  std::vector<std::uint64_t> count_;  // [0] counts what never began
};

// Lines that grow by a point a row: diagonals, or columns.
class GrowingLines {
 public:
  explicit GrowingLines(std::size_t n) : end_(n), length_(n) {}
  void add(std::size_t line, std::uint32_t row, LineLengths& lengths) {
    if (end_[line] != row) {
      lengths.add(length_[line]);
      length_[line] = 0;
    }
    ++length_[line];
    end_[line] = row + 1;
  }
  void end(LineLengths& lengths) const {
    for (const std::uint32_t length : length_) lengths.add(length);
  }

 private:
  std::vector<std::uint32_t> end_;  // the row after the last point
  std::vector<std::uint32_t> length_;
};

// All lines, from the rows of the lower triangle. The upper one is its mirror image: its diagonals
// are the same again, and its columns are the rows of the lower one.
class Lines {
 public:
  explicit Lines(std::size_t n)
      : diagonal_lengths(n), vertical_lengths(n), diagonals_(n), columns_(n), row_of_(n + 1) {}

  void add_row(std::uint32_t j, std::span<const std::uint32_t> row) {
    for (const std::uint32_t i : row) {
      diagonals_.add(j - i, j, diagonal_lengths);
      columns_.add(i, j, vertical_lengths);
      row_of_[i] = j;
    }
    for (const std::uint32_t i : row) {
      if (i > 0 && row_of_[i - 1] == j) continue;
      std::uint32_t end = i + 1;
      while (row_of_[end] == j) ++end;
      vertical_lengths.add(end - i);
    }
  }
  void end() {
    diagonals_.end(diagonal_lengths);
    columns_.end(vertical_lengths);
  }

  LineLengths diagonal_lengths;
  LineLengths vertical_lengths;

 private:
  GrowingLines diagonals_;
  GrowingLines columns_;
  std::vector<std::uint32_t> row_of_;  // the last row with a point in that column
};

// nan, of no sign, where there is nothing.
double ratio(double part, double whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : part / whole;
}

void set_measures(Recurrence& r, const Lines& lines) {
  const LineLengths& d = lines.diagonal_lengths;
  const LineLengths& v = lines.vertical_lengths;
  const std::size_t l_min = r.options.least_diagonal;
  const std::size_t v_min = r.options.least_vertical;
  RecurrenceMeasures& m = r.measures;
  m.rate = static_cast<double>(m.pairs) / pair_count(r.sequence.size(), r.options.theiler);
  m.determinism = ratio(d.points(l_min), d.points(1));
  m.mean_diagonal = ratio(d.points(l_min), d.lines(l_min));
  m.max_diagonal = d.longest(l_min);
  m.entropy = d.entropy(l_min);
  m.divergence = 1 / static_cast<double>(m.max_diagonal);
  m.laminarity = ratio(v.points(v_min), v.points(1));
  m.trapping_time = ratio(v.points(v_min), v.lines(v_min));
  m.max_vertical = v.longest(v_min);
}

// "2.0e10".
std::string count_text(double count) {
  const double exponent = std::floor(std::log10(count));
  return text(count / std::pow(10, exponent), 2) + "e" + std::to_string(static_cast<int>(exponent));
}

// What would take too long is refused before it begins.
void refuse_too_many(const PointSequence& sequence, double threshold, std::size_t theiler) {
  const double all = pair_count(sequence.size(), theiler);
  if (all <= kMostPairs) return;
  const std::vector<double> sample = sampled_distances(sequence, theiler);
  const auto share_of = [&](auto end) {
    return static_cast<double>(end - sample.begin()) / static_cast<double>(sample.size());
  };
  const double share = share_of(std::upper_bound(sample.begin(), sample.end(), threshold));
  if (share * all <= kMostPairs) return;
  const auto rank = static_cast<std::size_t>(kMostPairs / all * static_cast<double>(sample.size()));
  throw std::length_error(
      "threshold = " + text(threshold) + " makes about " + count_text(share * all) +
      " pairs, more than 1e10; give fewer points" +
      (sample[rank] > 0 ? ", or a threshold of about " + text(sample[rank], 2) : ""));
}

// Of the points of each diagonal, how many recur.
struct Shares {
  const Recurrence& matrix;

  double length(std::size_t lag) const {
    return static_cast<double>(matrix.diagonals.size()) - static_cast<double>(lag);
  }
  double operator()(std::size_t lag) const {
    return static_cast<double>(matrix.diagonals[lag]) / length(lag);
  }
  // Of a peak with a dip to less than its half on both sides: the middle between its halves.
  double middle(std::size_t peak) const {
    const double half = (*this)(peak) / 2;
    std::size_t left = peak;
    while ((*this)(left) >= half) --left;
    std::size_t right = peak;
    while ((*this)(right) >= half) ++right;
    const auto passed = [&](std::size_t outside, std::size_t inside) {
      return (half - (*this)(outside)) / ((*this)(inside) - (*this)(outside));
    };
    return (static_cast<double>(left) + passed(left, left + 1) + static_cast<double>(right) -
            passed(right, right - 1)) /
           2;
  }
};

}  // namespace

PointSequence recurrence_points(const Run& run, std::span<const double> times, Chart norm,
                                const Observer& observer) {
  if (times.size() < 2) {
    throw std::invalid_argument("two points at least are expected, got " +
                                std::to_string(times.size()) + " in t " + text(run.t0()) + " .. " +
                                text(run.t1()));
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[1] > times[0] ? !(times[i] > times[i - 1]) : !(times[i] < times[i - 1])) {
      throw std::invalid_argument("times must rise or fall, got " + text(times[i]) + " after " +
                                  text(times[i - 1]));
    }
  }
  PointSequence sequence;
  sequence.points.reserve(times.size());
  if (norm == Chart::kRotation) sequence.space = PointSequence::Space::kRotations;
  visit_times(times, observer, [&](double t) {
    if (norm == Chart::kRotation) {
      const Quaternion q = run.attitude(t).quaternion;
      sequence.points.push_back({q.w(), q.x(), q.y(), q.z()});
      return;
    }
    const Vector v = coordinates(norm, chart_state(run, t, norm, observer));
    if (!v.allFinite())
      throw std::invalid_argument("the chart has no value at t = " + text(t) + ": " + text(v));
    sequence.points.push_back({v.x(), v.y(), v.z(), 0});
  });
  return sequence;
}

std::optional<double> even_spacing(std::span<const double> times) {
  const double n = static_cast<double>(times.size());
  const double every = (times.back() - times.front()) / (n - 1);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double even = times.front() + static_cast<double>(i) * every;
    if (!(std::abs(times[i] - even) <= 1e-6 * std::abs(every))) return std::nullopt;
  }
  return std::abs(every);
}

Recurrence recurrence(PointSequence sequence, double threshold, const RecurrenceOptions& options,
                      const Observer& observer) {
  if (!(threshold > 0 && std::isfinite(threshold)))
    throw std::invalid_argument("threshold must be positive and finite, got " + text(threshold));
  if (options.least_diagonal == 0 || options.least_vertical == 0)
    throw std::invalid_argument("lmin and vmin must be at least 1, got 0");
  check_theiler(sequence.size(), options.theiler);
  refuse_too_many(sequence, threshold, options.theiler);
  Recurrence r{std::move(sequence), threshold, options, {}, {}};
  const std::size_t n = r.sequence.size();
  r.diagonals.resize(n);
  Lines lines(n);
  visit_rows(r, watched(n, observer, [&](std::size_t j, std::span<const std::uint32_t> row) {
               lines.add_row(static_cast<std::uint32_t>(j), row);
               for (const std::uint32_t i : row) ++r.diagonals[j - i];
               r.measures.pairs += row.size();
               return true;
             }));
  lines.end();
  set_measures(r, lines);
  return r;
}

std::vector<std::size_t> return_times(const PointSequence& sequence, double distance) {
  if (!(distance > 0)) {
    throw std::invalid_argument("the distance must be positive, got " + text(distance));
  }
  std::vector<std::size_t> gaps;
  std::size_t last = 0;
  for (std::size_t k = 1; k < sequence.size(); ++k) {
    if (sequence.distance(0, k) >= distance) continue;
    gaps.push_back(k - last);
    last = k;
  }
  return gaps;
}

void visit_rows(const Recurrence& matrix, const NeighbourVisitor& visit) {
  const std::size_t theiler = matrix.options.theiler;
  if (theiler == 1) return visit_neighbours(matrix.sequence, matrix.threshold, visit);
  std::vector<std::uint32_t> outside;
  visit_neighbours(matrix.sequence, matrix.threshold,
                   [&](std::size_t j, std::span<const std::uint32_t> row) {
                     outside.clear();
                     for (const std::uint32_t i : row)
                       if (i + theiler <= j) outside.push_back(i);
                     return visit(j, outside);
                   });
}

std::vector<RecurrentLag> recurrent_lags(const Recurrence& matrix, double least) {
  if (!(least > 0 && least <= 1))
    throw std::invalid_argument("least must be above 0 and at most 1, got " + text(least));
  const Shares share{matrix};
  std::vector<RecurrentLag> lags;
  double dip = 1;
  std::size_t peak = 0;  // 0 while the share falls
  for (std::size_t lag = matrix.options.theiler; share.length(lag) * least >= 1; ++lag) {
    const double here = share(lag);
    if (peak == 0) {
      dip = std::min(dip, here);
      if (here > 2 * dip) peak = lag;
    } else if (here > share(peak)) {
      peak = lag;
    } else if (here < share(peak) / 2) {
      if (share(peak) >= least) lags.push_back({share.middle(peak), share(peak)});
      dip = here;
      peak = 0;
    }
  }
  return lags;
}

}  // namespace rotor
