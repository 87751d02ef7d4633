#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// Collects the text of a JSON object, in the order of the calls.
class JSON_object
{
public:
  JSON_object& add(const char* key, double x) { return add_raw(key, number(x)); }
  JSON_object& add(const char* key, std::size_t n) { return add_raw(key, std::to_string(n)); }
  JSON_object& add(const char* key, const char* text) { return add(key, std::string(text)); }
  JSON_object& add(const char* key, bool is_true) { return add_raw(key, is_true ? "true" : "false"); }
  JSON_object& add(const char* key, const JSON_object& object) { return add_raw(key, object.text()); }

  JSON_object& add(const char* key, const std::vector<double>& numbers)
  {
    std::string list;
    for(double x : numbers)
      list += (list.empty() ? "" : ", ") + number(x);
    return add_raw(key, "[" + list + "]");
  }

  JSON_object& add(const char* key, const std::string& text)
  {
    std::string quoted;
    for(std::size_t i = 0; i < text.size(); i += (std::max)(size_of_character(text, i), std::size_t(1)))
    {
      const std::size_t size = size_of_character(text, i);
      if(size == 0)
        quoted += "\\ufffd"; // in place of a byte that is no text
      else if(text[i] == '"' || text[i] == '\\')
        quoted += std::string("\\") + text[i];
      else if(static_cast<unsigned char>(text[i]) < ' ')
        quoted += ' ';
      else
        quoted += text.substr(i, size);
    }
    return add_raw(key, "\"" + quoted + "\"");
  }

  std::string text() const { return "{" + m_members + "}"; }

private:
  static std::string number(double x)
  {
    std::ostringstream os;
    os.precision(17);
    os << x;
    return std::isfinite(x) ? os.str() : "null";
  }

  // Returns the number of bytes of the UTF-8 character at i, or 0 if there is none. Surrogates and overlong forms are none.
  static std::size_t size_of_character(const std::string& text, const std::size_t i)
  {
    const auto byte = [&](const std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
    const unsigned first = byte(i);
    const std::size_t size = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    for(std::size_t k = 1; k < size; ++k)
      if((byte(i + k) & 0xC0) != 0x80)
        return 0;
    const unsigned second = byte(i + 1);
    const bool is_none = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)
                      || (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
    return size > 1 && is_none ? 0 : size;
  }

  JSON_object& add_raw(const char* key, const std::string& value)
  {
    m_members += std::string(m_members.empty() ? "" : ", ") + "\"" + key + "\": " + value;
    return *this;
  }

  std::string m_members;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H
