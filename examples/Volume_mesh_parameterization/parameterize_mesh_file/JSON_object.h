#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// Collects the text of a JSON object, in the order of the calls.
class JSON_object
{
public:
  JSON_object& add(const char* key, double x)
  {
    return add_raw(key, number(x));
  }

  JSON_object& add(const char* key, std::size_t n)
  {
    return add_raw(key, std::to_string(n));
  }

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
    for(char c : text)
    {
      if(c == '"' || c == '\\')
        quoted += '\\';
      quoted += (c >= 0 && c < ' ') ? ' ' : c;
    }
    return add_raw(key, "\"" + quoted + "\"");
  }

  JSON_object& add(const char* key, const char* text)
  {
    return add(key, std::string(text));
  }

  JSON_object& add(const char* key, bool is_true)
  {
    return add_raw(key, is_true ? "true" : "false");
  }

  JSON_object& add(const char* key, const JSON_object& object)
  {
    return add_raw(key, object.text());
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

  JSON_object& add_raw(const char* key, const std::string& value)
  {
    m_members += std::string(m_members.empty() ? "" : ", ") + "\"" + key + "\": " + value;
    return *this;
  }

  std::string m_members;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H
