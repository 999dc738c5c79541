#include <halfedge/result.h>

namespace halfedge {

Failure::Failure(Error&& error) : error_(new Error(std::move(error))) {}

Failure::Failure(const Error& error) : error_(new Error(error)) {}

void Failure::forget(Error* error) { delete error; }

}  // namespace halfedge
