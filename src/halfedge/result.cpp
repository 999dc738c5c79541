#include <halfedge/result.h>

#include <utility>

namespace halfedge {

IndexList::IndexList() = default;
IndexList::IndexList(std::initializer_list<Index> items) : vector(items) {}
IndexList::IndexList(std::vector<Index> items) : vector(std::move(items)) {}
IndexList::IndexList(std::span<const Index> items) : vector(items.begin(), items.end()) {}
IndexList::IndexList(const IndexList& other) = default;
IndexList::IndexList(IndexList&& other) noexcept = default;
IndexList& IndexList::operator=(const IndexList& other) = default;
IndexList& IndexList::operator=(IndexList&& other) noexcept = default;
IndexList::~IndexList() = default;

Error::Error() = default;
Error::Error(std::string_view of_program, std::string for_people, Witness items)
    : code(of_program), message(std::move(for_people)), witness(std::move(items)) {}
Error::Error(const Error& other) = default;
Error::Error(Error&& other) noexcept = default;
Error& Error::operator=(const Error& other) = default;
Error& Error::operator=(Error&& other) noexcept = default;
Error::~Error() = default;

Failure::Failure(std::string_view code, std::string&& message, Witness&& witness)
    : error_(new Error(code, std::move(message), std::move(witness))) {}

Failure::Failure(Error&& error) : error_(new Error(std::move(error))) {}

Failure::Failure(const Error& error) : error_(new Error(error)) {}

void Failure::forget(Error* error) { delete error; }

Error no_memory_for(std::string_view what) {
  return {"out-of-memory", "There is not enough memory for " + std::string(what) + "."};
}

}  // namespace halfedge
