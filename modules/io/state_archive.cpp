#include "io/state_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/binary_object.hpp>
#include <numeric>
#include <sstream>
#include <streambuf>
#include <type_traits>

#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {
namespace {

using boost::serialization::make_binary_object;

template <class T>
struct IsField : std::false_type {};
template <class T>
struct IsField<Field<T>> : std::true_type {
  // Arrays are written as they lie in memory.
  static_assert(std::is_trivially_copyable_v<T>);
};

/// Tables whose number of rows changes during a run. Secants are those of the contacts that a stiffness matrix
/// was made of; whoever uses them asks whether they still fit.
bool is_contact_field(const std::string& name) {
  return (name.find("_contacts.") != std::string::npos && name.find(".law_begin") == std::string::npos) ||
         name == "loading.secants";
}

/// Memory of adaptive damping and of loading stays empty until it is used.
bool may_be_empty(const std::string& name) {
  return name.rfind("relaxation.", 0) == 0 || name == "loading.direction" || name == "loading.older_direction" ||
         name == "loading.places";
}

std::uint64_t wanted_length(const std::string& name, std::uint64_t built, const Model& model) {
  if (name == "relaxation.node_force") return model.nodes.size();
  if (name == "relaxation.beam_force" || name == "relaxation.beam_moment") return model.beam_nodes.size();
  if (name == "relaxation.momentum" || name == "relaxation.force" || name == "loading.direction" ||
      name == "loading.older_direction" || name == "loading.places")
    return FreedomNumbers(model).count();
  if (may_be_empty(name)) return model.particles.size();
  return built;
}

/// The archive has no names of its own: fields must be the same, in the same order.
void check_names(const ArrayLengths& lengths, const State& state) {
  const auto same_name = [](const auto& a, const auto& b) { return a.first == b.first; };
  const ArrayLengths built = array_lengths(state);
  const auto [read, wanted] = std::mismatch(lengths.begin(), lengths.end(), built.begin(), built.end(), same_name);
  if (wanted != built.end()) throw FileError(fmt::format("the checkpoint lacks the field '{}'", wanted->first));
  if (read != lengths.end()) throw FileError(fmt::format("the checkpoint has a field '{}' too many", read->first));
}

void check_lengths(const ArrayLengths& lengths, const Model& model, const State& state) {
  const ArrayLengths built = array_lengths(state);
  for (std::size_t i = 0; i < built.size(); ++i) {
    const auto& [name, length] = lengths[i];
    if (is_contact_field(name)) continue;
    const std::uint64_t wanted = wanted_length(name, built[i].second, model);
    if (length == wanted || (length == 0 && may_be_empty(name))) continue;
    throw FileError(
        fmt::format("the field '{}' of the checkpoint has {} entries, the case needs {}", name, length, wanted));
  }
}

/// Appends to a text what an archive writes.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string& text) : text_(text) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize n_bytes) override {
    text_.append(bytes, static_cast<std::size_t>(n_bytes));
    return n_bytes;
  }
  int_type overflow(int_type byte) override {
    if (!traits_type::eq_int_type(byte, traits_type::eof())) text_.push_back(traits_type::to_char_type(byte));
    return traits_type::not_eof(byte);
  }

 private:
  std::string& text_;
};

/// What every archive of this Boost version begins with. Boost takes the length of its signature from the archive, and
/// would ask for as much memory.
std::string archive_begin() {
  std::string text;
  TextBuffer buffer(text);
  const boost::archive::binary_oarchive archive(buffer);
  return text;
}

void read_archive(const std::string& archive_bytes, const ArrayLengths& lengths, State& state) {
  if (!archive_bytes.starts_with(archive_begin()))
    throw FileError("the archive of the checkpoint begins as no archive");
  try {
    std::istringstream stream(archive_bytes);
    boost::archive::binary_iarchive archive(stream);
    auto length = lengths.begin();
    visit_fields(state, [&]<class T>(const std::string& name, T& field, FieldRole) {
      if constexpr (IsField<T>::value) {
        const std::uint64_t n_entries = (length++)->second;
        // What is too long for the archive may be too long for any memory.
        if (n_entries > archive_bytes.size() / sizeof(typename T::value_type)) {
          throw FileError(fmt::format("the field '{}' of the checkpoint is longer than its archive", name));
        }
        field.assign(n_entries, typename T::value_type{});
        if (!field.empty()) {
          archive >> make_binary_object(field.data(), field.size() * sizeof(typename T::value_type));
        }
      } else {
        archive >> field;
      }
    });
  } catch (const boost::archive::archive_exception& error) {
    throw FileError(fmt::format("the archive of the checkpoint cannot be read: {}", error.what()));
  }
}

/// The history columns that the names of the fields tell of.
std::vector<HistoryColumn> columns_of(const ArrayLengths& lengths, const std::string& table) {
  const std::string prefix = table + ".history.";
  std::vector<HistoryColumn> columns;
  for (const auto& [name, length] : lengths) {
    if (name.rfind(prefix, 0) == 0) columns.push_back({name.substr(prefix.size()), 0.0, {}});
  }
  return columns;
}

/// Enough for an archive: its arrays, and its numbers and first lines.
std::size_t archive_size(const State& state) {
  std::size_t n_bytes = 4096;
  visit_fields(state, [&]<class T>(const std::string&, const T& field, FieldRole) {
    if constexpr (IsField<T>::value) n_bytes += field.size() * sizeof(typename T::value_type);
  });
  return n_bytes;
}

bool all_below(const Field<Index>& rows, std::size_t count) {
  return std::all_of(rows.begin(), rows.end(),
                     [&](Index row) { return row >= 0 && static_cast<std::size_t>(row) < count; });
}

/// Rows that point outside of the model would be followed blindly by the step.
void check_contacts(const char* name, const ContactTable& contacts, const Model& model, std::size_t n_first,
                    std::size_t n_second) {
  const auto n_history = std::accumulate(model.laws.begin(), model.laws.end(), std::size_t{0},
                                         [](std::size_t sum, const LawBinding& law) { return sum + law.n_history; });
  bool is_sound = contacts.law_begin.size() == model.laws.size() + 1 && contacts.history.size() == n_history &&
                  all_below(contacts.law, model.laws.size()) && all_below(contacts.first, n_first) &&
                  all_below(contacts.second, n_second) && std::is_sorted(contacts.law.begin(), contacts.law.end());
  visit_rows(contacts, [&](const char*, const auto& field, FieldRole) {
    is_sound = is_sound && field.size() == contacts.size();
  });
  std::size_t column = 0;
  for (std::size_t law = 0; is_sound && law < model.laws.size(); ++law) {
    const auto begin = std::lower_bound(contacts.law.begin(), contacts.law.end(), static_cast<Index>(law));
    const auto end = std::upper_bound(contacts.law.begin(), contacts.law.end(), static_cast<Index>(law));
    is_sound = contacts.law_begin[law] == begin - contacts.law.begin() &&
               contacts.law_begin[law + 1] == end - contacts.law.begin();
    for (std::size_t k = 0; k < model.laws[law].n_history; ++k, ++column) {
      is_sound = is_sound && contacts.history[column].values.size() == static_cast<std::size_t>(end - begin);
    }
  }
  if (!is_sound) throw FileError(fmt::format("the {} of the checkpoint do not fit the case", name));
}

}  // namespace

std::string save_state(const State& state, std::string used) {
  used.clear();
  used.reserve(archive_size(state));
  TextBuffer buffer(used);
  {
    boost::archive::binary_oarchive archive(buffer);
    visit_fields(state, [&]<class T>(const std::string&, const T& field, FieldRole) {
      if constexpr (IsField<T>::value) {
        if (!field.empty()) {
          // Boost takes binary objects by pointer to non-const, and does not write to them.
          auto* data = const_cast<typename T::value_type*>(field.data());
          archive << make_binary_object(data, field.size() * sizeof(typename T::value_type));
        }
      } else {
        archive << field;
      }
    });
  }
  return used;
}

ArrayLengths array_lengths(const State& state) {
  ArrayLengths lengths;
  visit_fields(state, [&]<class T>(const std::string& name, const T& field, FieldRole) {
    if constexpr (IsField<T>::value) lengths.emplace_back(name, field.size());
  });
  return lengths;
}

void load_state(const std::string& archive, const ArrayLengths& lengths, const Model& model, State& state) {
  check_names(lengths, state);
  check_lengths(lengths, model, state);
  read_archive(archive, lengths, state);
  const std::size_t n_particles = model.particles.size();
  check_contacts("contacts of particles", state.particle_contacts, model, n_particles, n_particles);
  check_contacts("contacts with elements", state.facet_contacts, model, n_particles, model.facets.size());
  check_contacts("contacts with nodes", state.corner_contacts, model, n_particles, model.nodes.size());
  check_contacts("seats", state.seat_contacts, model, model.nodes.size(), model.facets.size());
}

State load_unknown_state(const std::string& archive, const ArrayLengths& lengths) {
  State state;
  state.particle_contacts.history = columns_of(lengths, "particle_contacts");
  state.facet_contacts.history = columns_of(lengths, "facet_contacts");
  state.corner_contacts.history = columns_of(lengths, "corner_contacts");
  state.seat_contacts.history = columns_of(lengths, "seat_contacts");
  check_names(lengths, state);
  read_archive(archive, lengths, state);
  return state;
}

}  // namespace ligament
