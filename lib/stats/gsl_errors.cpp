#include "stats/gsl_errors.hpp"

#include <gsl/gsl_errno.h>

namespace slidezone {

void keep_gsl_from_aborting() { [[maybe_unused]] static const gsl_error_handler_t* former = gsl_set_error_handler_off(); }

}  // namespace slidezone
