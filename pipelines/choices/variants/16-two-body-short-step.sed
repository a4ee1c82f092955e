s/^contact = .*/contact = "two-body"/
