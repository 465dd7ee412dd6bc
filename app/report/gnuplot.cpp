#include "report/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "io/atomic_file.hpp"

namespace ligament {
namespace {

constexpr int status_of_missing_program = 127;
constexpr const char* messages = "gnuplot.log";

std::string whole_script(const Figure& figure) {
  const std::string png =
      fmt::format("set terminal pngcairo size {},{} font 'Helvetica,13' fontscale 3 linewidth 3\nset output '{}.png'\n",
                  3 * figure.width, 3 * figure.height, figure.name);
  if (!figure.svg.empty()) return "set encoding utf8\n" + png + figure.script;
  return fmt::format(
      "set encoding utf8\n"
      "set terminal svg size {},{} font 'Helvetica,13' background 'white' name '{}'\nset output '{}.svg'\n{}{}replot\n",
      figure.width, figure.height, figure.name, figure.name, figure.script, png);
}

/// In the child process: gnuplot with its messages in a file; never returns.
[[noreturn]] void become_gnuplot(const char* folder, const char* script) {
  if (::chdir(folder) == 0) {
    const int log = ::open(messages, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (log >= 0) ::dup2(log, STDERR_FILENO);
    ::execlp("gnuplot", "gnuplot", script, nullptr);
  }
  ::_exit(status_of_missing_program);
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

void draw(const Figure& figure, const std::filesystem::path& folder) {
  const std::string script = figure.name + ".gnuplot";
  write_atomically(folder / script, whole_script(figure));
  if (!figure.svg.empty()) write_atomically(folder / (figure.name + ".svg"), figure.svg);
  const pid_t child = ::fork();
  if (child < 0) throw FileError("no process for gnuplot could be started");
  if (child == 0) become_gnuplot(folder.c_str(), script.c_str());
  int status = 0;
  ::waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == status_of_missing_program) {
    throw FileError("gnuplot, which draws the pictures, was not found: install it (Debian: gnuplot-nox)");
  }
  if (code != 0) {
    throw FileError(fmt::format("{}: gnuplot failed, its messages are in {}", (folder / script).string(),
                                (folder / messages).string()));
  }
  std::filesystem::remove(folder / messages);
}

}  // namespace ligament
