#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// The good case with more tables at its end.
void check_added(const std::string& tables, const std::string& message, const std::string& at) {
  CAPTURE(tables);
  const std::string text = good_case() + tables;
  check_rejected(text, "case.toml:" + place_of(at, text) + ": " + message);
}

}  // namespace

TEST_CASE("criteria that end a run") {
  check_added("[stop]\n", "give 'gauge', 'cut_off_share' or 'crack_span' in [stop]", "[stop]");
  check_added("[stop]\nabove = 1\n", "missing key 'gauge' in [stop]", "[stop]");
  check_added("[stop]\ngauge = \"u\"\n", "give 'drop_to_share', 'above' or 'below' in [stop]", "[stop]");
  check_added("[stop]\ngauge = \"uu\"\nabove = 1\n",
              "there is no gauge 'uu' in [stop] (there are: 'u', 'r'); did you mean 'u'?", "\"uu\"");
  check_added("[stop]\ncut_off_share = 0.5\n", "'cut_off_share' is 0.5, but must be greater than 0 and less than 0.5",
              "0.5\n");
  check_added("[[limit]]\nname = \"much\"\ngauge = \"r\"\n",
              "give 'drop_to_share', 'above' or 'below' in [[limit]] 'much'", "[[limit]]");
  check_added("[[limit]]\nname = \"much\"\nabove = 1\n", "missing key 'gauge' in [[limit]] 'much'", "[[limit]]");
}

TEST_CASE("rows between equilibria where there are no equilibria") {
  check_added("[output]\ntransient_every = 10\n",
              "'transient_every' is for method = \"quasi_static\" in [solver]: other methods have no states between "
              "their steps",
              "10\n");
}

TEST_CASE("uniaxial tests") {
  check_added("[uniaxial]\n", "[uniaxial] is for kind = \"uniaxial\" alone", "[uniaxial]");
  const std::string uniaxial = edited("thickness = \"1 m\"", "thickness = \"1 m\"\nkind = \"uniaxial\"");
  const std::string table = "[uniaxial]\nload = \"u\"\nelongation = \"u\"\n";
  check_rejected(uniaxial + table, "case.toml:" + place_of("\"u\"\nelong", uniaxial + table) +
                                       ": gauge 'u' is no 'reaction' in [uniaxial]: it tells of no load");
  const std::string strange = "[uniaxial]\nload = \"r\"\nelongation = \"v\"\n";
  check_rejected(uniaxial + strange, "case.toml:" + place_of("\"v\"", uniaxial + strange) +
                                         ": there is no gauge 'v' in [uniaxial] (there are: 'u', 'r')");
}

TEST_CASE("places of gauges") {
  check_edit("displacement = { node = 4,", "displacement = { point = [\"9 m\", \"1 m\"],",
             "there is no element or particle at (9 m, 1 m) in [[gauge]] 'u'", "{ point");
  check_edit("displacement = { node = 4,", "displacement = { relative_to = [\"lift\"], node = 4,",
             "there is no [[support]] 'lift' in [[gauge]] 'u'", "{ relative_to");
}
