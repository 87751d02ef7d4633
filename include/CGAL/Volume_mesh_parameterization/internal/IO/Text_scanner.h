// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TEXT_SCANNER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TEXT_SCANNER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#ifndef _WIN32
#  include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>
#  include <poll.h>
#  include <cerrno>
#endif

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <string_view>
#include <system_error>

namespace CGAL::Volume_mesh_parameterization::internal {

// Thrown where a budget is exhausted while a file is read.
struct Interruption {};

inline void go_on(const Budget& budget)
{
  if(budget.is_exhausted())
    throw Interruption();
}

// Calls `read(budget)` with the limits of the named parameters, and returns false if they end it. `Tags` are the named parameters
// that the caller has besides these limits.
// Puts the name of the file, if there is one, in front of the sentence of a failure.
template <typename... Tags, typename NamedParameters, typename Read>
bool read_within_limits(const NamedParameters& np, const std::string& filename, const Read& read)
{
  check_named_parameters<Tags...>(np);
  Limits<NamedParameters> limits(np);
  const Budget budget = limits.budget();
  try { read(budget); }
  catch(const Interruption&) { return false; }
  catch(const Input_error& error) { throw Input_error(filename.empty() ? error.what() : filename + ": " + error.what()); }
  return true;
}

// Writes a file by `write(stream)`, and returns whether it is complete. If it is not, it stays as it was.
template <typename Write>
bool write_file(const std::string& filename, const Write& write)
{
#ifdef _WIN32
  std::stringstream content;
  write(content);
  std::ofstream file(filename, std::ios::binary);
  return file << content.rdbuf() && file.flush();
#else
  const auto succeeds = [](const auto& f)
  {
    try { f(); }
    catch(const std::runtime_error&) { return false; }
    return true;
  };
  std::optional<IO::Output_file> file;
  if(!succeeds([&] { file.emplace(filename); }))
    return false;
  write(file->stream());
  return succeeds([&] { file->commit(); });
#endif
}

// The rest of a stream, or its next `size` characters.
inline std::string read_text(std::istream& is, const Budget& budget, const std::size_t size = std::string::npos)
{
  constexpr std::size_t chunk = 1 << 16; // a guess; number of bytes
  std::string text;
  while(is && text.size() < size)
  {
    go_on(budget);
    const std::size_t begin = text.size();
    text.resize(begin + (std::min)(chunk, size - begin));
    is.read(&text[begin], static_cast<std::streamsize>(text.size() - begin));
    text.resize(begin + static_cast<std::size_t>(is.gcount()));
  }
  if(is.bad())
    throw Input_error("the file cannot be read");
  return text;
}

// Returns the reason why the last file was not opened.
inline std::string sentence_on_unopened_file()
{
  return errno == EACCES ? "the file cannot be opened, because its permissions exclude this user; chmod u+r allows it"
                         : "the file cannot be opened";
}

// All of a file. Where a pipe has nothing to read yet, and perhaps never will, the budget is asked again and again.
inline std::string read_file(const std::string& filename, const Budget& budget)
{
#ifdef _WIN32
  std::ifstream is(filename, std::ios::binary);
  if(!is)
    throw Input_error(sentence_on_unopened_file());
  return read_text(is, budget);
#else
  struct File
  {
    const int descriptor;
    ~File() { close(descriptor); }
  } const file = { open_file(filename, O_RDONLY) };
  if(file.descriptor < 0)
    throw Input_error(sentence_on_unopened_file());
  constexpr int milliseconds = 50; // a guess; between two looks at the budget
  constexpr std::size_t chunk = 1 << 16; // a guess; number of bytes
  std::string text;
  for(std::size_t size = 0;;)
  {
    go_on(budget);
    pollfd state = { file.descriptor, POLLIN, 0 };
    if(poll(&state, 1, milliseconds) <= 0)
      continue;
    text.resize(size + chunk);
    const ssize_t result = ::read(file.descriptor, &text[size], chunk);
    if(result < 0 && errno != EINTR && errno != EAGAIN)
      throw Input_error("the file cannot be read");
    size += static_cast<std::size_t>((std::max)(result, ssize_t(0)));
    text.resize(size);
    if(result == 0)
      return text;
  }
#endif
}

// Cuts a text into words separated by blanks and counts its lines. A `#` hides the rest of its line. A copy is a bookmark.
class Text_scanner
{
public:
  Text_scanner(const std::string_view text, const Budget& budget, const std::size_t first_line = 1)
    : m_text(text), m_budget(&budget), m_line(first_line)
  {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // of UTF-8
    if(first_line == 1 && text.substr(0, byte_order_mark.size()) == byte_order_mark)
      m_position = byte_order_mark.size();
  }

  // the next word, empty at the end of the text
  std::string_view next_word()
  {
    skip_blanks();
    const std::size_t begin = m_position;
    while(m_position < m_text.size() && !is_blank(m_text[m_position]) && m_text[m_position] != '#')
      ++m_position;
    return m_text.substr(begin, m_position - begin);
  }

  // Does the next word begin with a quote?
  bool is_at_quote()
  {
    const std::string_view text = rest();
    return !text.empty() && (text[0] == '\'' || text[0] == '"');
  }

  // the text between the quote at which the next word begins and the next such quote of the text
  std::string_view next_quoted()
  {
    const std::string_view text = rest();
    const std::size_t size = text.find(text[0], 1);
    if(size == text.npos)
      fail("the quote before " + quote(text.substr(1)) + " is not closed");
    m_position += size + 1;
    return text.substr(1, size - 1);
  }

  // the text from the next word on
  std::string_view rest()
  {
    skip_blanks();
    return m_text.substr(m_position);
  }

  // the next word as a number; `what` names it in the sentence of a failure
  template <typename Number>
  Number next_number(const char* what)
  {
    const std::string_view word = next_word();
    if(word.empty())
      fail("the " + std::string(m_name) + " ends where " + what + " should be");

    Number number{};
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
    if(!parse(word.data() + has_plus, word.data() + word.size(), number))
      fail(quote(word) + " is not " + what);
    return number;
  }

  // the rest of the line that the next word is on, which is passed
  Text_scanner next_line()
  {
    skip_blanks();
    Text_scanner result(*this);
    m_position = (std::min)(m_text.find('\n', m_position), m_text.size());
    result.m_text = m_text.substr(0, m_position);
    result.m_name = "line";
    return result;
  }

  void expect_end(const std::string& last)
  {
    const std::string_view word = next_word();
    if(!word.empty())
      fail(quote(word) + " follows " + last);
  }

  std::size_t line() const { return m_line; }

  [[noreturn]] void fail(const std::string& sentence) const { fail(m_line, sentence); }

  [[noreturn]] static void fail(const std::size_t line, const std::string& sentence)
  { throw Input_error("line " + std::to_string(line) + ": " + sentence); }

  // the beginning of a word, fit for a terminal
  static std::string quote(std::string_view word)
  {
    const std::size_t longest = 30;
    std::string text(word.substr(0, longest));
    std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + text + (word.size() > longest ? "..." : "") + "'";
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

  template <typename Number>
  static bool parse(const char* const first, const char* const last, Number& number)
  {
    const std::from_chars_result result = std::from_chars(first, last, number);
    return result.ec == std::errc() && result.ptr == last;
  }

  // Not every standard library has std::from_chars for numbers with a point, and it refuses those that round to 0. Streams read
  // them by this facet, correctly rounded and whatever the global locale is.
  static bool parse(const char* const first, const char* const last, double& number)
  {
#ifdef __cpp_lib_to_chars
    if(parse<double>(first, last, number) && std::isfinite(number))
      return true;
#endif
    struct Parser : std::num_get<char, const char*> {};
    struct Format : std::ios
    {
      Format() : std::ios(nullptr) { imbue(std::locale::classic()); }
    };
    static const Parser parser;
    thread_local Format format;
    std::ios::iostate error = std::ios::goodbit;
    return parser.get(first, last, format, error, number) == last && !(error & std::ios::failbit) && std::isfinite(number);
  }

  void skip_blanks()
  {
    ask();
    for(bool is_comment = false; m_position < m_text.size(); ++m_position)
    {
      const char c = m_text[m_position];
      if(c == '\n')
      {
        ++m_line;
        is_comment = false;
        ask();
      }
      else if(c == '#')
        is_comment = true;
      else if(!is_comment && !is_blank(c))
        return;
    }
  }

  void ask()
  {
    if(m_position < m_next_question)
      return;
    m_next_question = m_position + (1 << 16);
    go_on(*m_budget);
  }

  std::string_view m_text;
  const Budget* m_budget;
  const char* m_name = "file";
  std::size_t m_line, m_position = 0, m_next_question = 0;
};

// Writes text and numbers to a stream, whatever its locale and precision. Floating-point numbers get the fewest digits
// (at most 17) from which reading restores the same bits. A failure is left in the state of the stream.
class Text_writer
{
public:
  explicit Text_writer(std::ostream& os) : m_os(os) {}
  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;
  ~Text_writer() { flush(); }

  // Writes the rest, and returns whether the stream has taken everything.
  bool finish()
  {
    flush();
    return m_os.good();
  }

  Text_writer& operator<<(const std::string_view text)
  {
    m_buffer += text;
    if(m_buffer.size() >= (1 << 16)) // streams of files have small buffers
      flush();
    return *this;
  }

  template <typename Number, typename = std::enable_if_t<std::is_arithmetic_v<Number> > >
  Text_writer& operator<<(const Number number)
  {
    char digits[32];
    const std::to_chars_result result = std::to_chars(digits, digits + sizeof(digits), number);
    return *this << std::string_view(digits, static_cast<std::size_t>(result.ptr - digits));
  }

private:
  void flush()
  {
    m_os.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_buffer.clear();
  }

  std::ostream& m_os;
  std::string m_buffer;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TEXT_SCANNER_H
