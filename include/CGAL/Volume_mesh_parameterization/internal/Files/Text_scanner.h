// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_TEXT_SCANNER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_TEXT_SCANNER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Input_error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <ios>
#include <locale>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL::Volume_mesh_parameterization::internal {

// Cuts a text into words separated by blanks and counts its lines. A `#` hides the rest of its line.
// A copy is a bookmark.
class Text_scanner
{
public:
  explicit Text_scanner(std::string_view text, const std::size_t first_line = 1)
    : m_text(text), m_line(first_line)
  {}

  // the next word, empty at the end of the text
  std::string_view next_word()
  {
    skip_blanks();
    const std::size_t begin = m_position;
    while(m_position < m_text.size() && !is_blank(m_text[m_position]) && m_text[m_position] != '#')
      ++m_position;
    return m_text.substr(begin, m_position - begin);
  }

  // the next word as a number; `what` names it in the sentence of a failure
  template <typename Number>
  Number next_number(const char* what)
  {
    const std::string_view word = next_word();
    if(word.empty())
      fail("the file ends where " + std::string(what) + " should be");

    Number number{};
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
    if(!parse(word.data() + has_plus, word.data() + word.size(), number))
      fail(quote(word) + " is not " + what);
    return number;
  }

  bool has_word() const
  {
    return !Text_scanner(*this).next_word().empty();
  }

  // Is there another word on the line of the last one?
  bool has_word_on_line() const
  {
    Text_scanner ahead(*this);
    return !ahead.next_word().empty() && ahead.m_line == m_line;
  }

  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw Input_error("line " + std::to_string(m_line) + ": " + sentence);
  }

  // the beginning of a word, fit for a terminal
  static std::string quote(std::string_view word)
  {
    const std::size_t longest = 30;
    std::string text(word.substr(0, longest));
    std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + text + (word.size() > longest ? "..." : "") + "'";
  }

private:
  static bool is_blank(char c)
  {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }

  template <typename Integer>
  static bool parse(const char* const first, const char* const last, Integer& number)
  {
    const std::from_chars_result result = std::from_chars(first, last, number);
    return result.ec == std::errc() && result.ptr == last;
  }

  // Not every standard library has std::from_chars for numbers with a point. Streams read them by this facet, correctly
  // rounded and whatever the global locale is.
  static bool parse(const char* const first, const char* const last, double& number)
  {
    struct Parser : std::num_get<char, const char*> {};
    struct Format : std::ios
    {
      Format() : std::ios(nullptr) { imbue(std::locale::classic()); }
    };
    static const Parser parser;
    thread_local Format format;
    std::ios::iostate error = std::ios::goodbit;
    return parser.get(first, last, format, error, number) == last && !(error & std::ios::failbit)
        && std::isfinite(number);
  }

  void skip_blanks()
  {
    for(bool is_comment = false; m_position < m_text.size(); ++m_position)
    {
      const char c = m_text[m_position];
      if(c == '\n')
      {
        ++m_line;
        is_comment = false;
      }
      else if(c == '#')
        is_comment = true;
      else if(!is_comment && !is_blank(c))
        return;
    }
  }

  std::string_view m_text;
  std::size_t m_position = 0;
  std::size_t m_line;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_TEXT_SCANNER_H
